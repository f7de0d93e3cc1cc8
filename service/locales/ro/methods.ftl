# Cinematica inversă.

error-inverse_form_unknown = Axele acestui braț nu se succed într-un mod a cărui cinematică inversă să fie cunoscută în formă simbolică: ele trebuie să fie perpendiculare sau paralele, cu două sau trei cuple care se mișcă într-un plan și cu o încheietură ale cărei axe se intersectează într-un punct. Numeric se rezolvă oricum.
error-inverse_form_idle_joint = Cupla { $joint } nu face nimic acolo unde soluția simbolică are nevoie de ea: punctul pe care ar trebui să îl miște se află pe axa ei sau o altă cuplă îl mișcă la fel, fiindcă o lungime dintre axe este 0 sau două cuple de translație sunt paralele. Soluția numerică funcționează oricum.
error-inverse_joint_count =
    Cinematica inversă se calculează pentru 1 până la { $limit ->
        [one] { $limit } cuplă
        [few] { $limit } cuple
       *[other] { $limit } de cuple
    }; tabelul are { $count }.
error-limits_wrong_length =
    Brațul are { $expected ->
        [one] { $expected } cuplă
        [few] { $expected } cuple
       *[other] { $expected } de cuple
    }, dar { $given ->
        [one] s-a dat { $given } limită
        [few] s-au dat { $given } limite
       *[other] s-au dat { $given } de limite
    }; dați câte una pentru fiecare cuplă, null acolo unde nu există limită.
error-limits_reversed = Dați ca limite ale cuplei { $joint } valoarea minimă și valoarea maximă, în această ordine.
error-limits_too_far = Limitele cuplei { $joint } sunt ambele la peste { $limit } rad de 0. Scădeți din amândouă rotații complete.
error-pose_tolerance_out_of_range = Toleranța este un număr pozitiv de cel mult { $limit }.
error-targets_wrong_shape = Dați mai multe ținte ca o listă de matrice 4×4.
error-workspace_condition_unmet = Nu s-a găsit nicio configurație în limite care să îndeplinească această condiție.
