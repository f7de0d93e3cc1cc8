# Atașarea sistemelor: reguli și refuzuri.

rule-z_not_along_axis = z trebuie să fie de-a lungul axei { $axis }, deoarece cupla { $axis } se rotește în jurul acestei axe z sau alunecă de-a lungul ei.
rule-origin_not_on_axis = Originea trebuie să se afle pe axa { $axis }, deoarece axa z a acestui sistem este de-a lungul ei.
rule-origin_not_on_common_normal = Originea trebuie să fie acolo unde perpendiculara comună a axelor { $first } și { $second } întâlnește axa acestui sistem, deoarece a se măsoară pe acea perpendiculară.
rule-origin_not_at_intersection = Axele { $first } și { $second } se intersectează: originea se pune în punctul lor de intersecție, deoarece acolo a este zero.
rule-x_not_across_z = x trebuie să fie perpendiculară pe z, deoarece axele unui sistem sunt perpendiculare.
rule-x_not_along_common_normal = x trebuie să fie de-a lungul perpendicularei comune a axelor { $first } și { $second }, deoarece a se măsoară de-a lungul lui x și este cea mai scurtă distanță dintre axe.
rule-x_not_across_both_axes = x trebuie să fie perpendiculară pe ambele axe { $first } și { $second }, deoarece α rotește una peste cealaltă în jurul lui x.
rule-first_x_misses_axis = Axa x a primului sistem trebuie să intersecteze axa { $axis } în unghi drept, deoarece rândul lui are doar a și α, de-a lungul și în jurul lui x, ca să ajungă acolo.
rule-last_x_misses_axis = Axa x a ultimului sistem trebuie să intersecteze axa { $axis } în unghi drept, deoarece rândul lui are doar a și α, de-a lungul și în jurul lui x, ca să vină de acolo.
rule-z_reversed = z este opusă sensului pozitiv al axei { $axis }. Este permis; variabila cuplei apare atunci cu semnul minus.
rule-x_reversed = x este îndreptată de la axa { $second } spre axa { $first }. Este permis; lungimea elementului devine atunci negativă.
rule-offset_could_vanish = Cu altă origine pe această axă, d{ $joint } ar fi zero.
rule-angle_could_vanish = Cu altă direcție a lui x, θ{ $joint } ar fi zero.
rule-first_not_simplest = Sistemul 0 poate fi ales astfel încât să se anuleze mai mulți parametri.
rule-last_not_simplest = Ultimul sistem poate fi ales astfel încât să se anuleze mai mulți parametri.

error-axes_wrong_number =
    Un lanț are între 1 și { $limit ->
        [one] { $limit } axă
        [few] { $limit } axe
       *[other] { $limit } de axe
    }; acesta are { $count }.
error-axis_joint_unknown = Cupla unei axe este de rotație (revolute) sau de translație (prismatic).
error-gripper_jaws_along_approach = Fălcile alunecă transversal față de direcția de apropiere, nu de-a lungul ei.
error-vector_malformed = Dați trei numere finite x, y, z, niciunul mai mare decât { $limit }.
error-direction_zero = O direcție are nevoie de lungime: 0, 0, 0 nu indică nicăieri.
error-frames_too_many =
    Un lanț cu { $count ->
        [one] { $count } cuplă
        [few] { $count } cuple
       *[other] { $count } de cuple
    } are sistemele de la 0 la { $count }.
error-frame_y_not_z_cross_x = y rezultă din z și x. Omiteți-l sau dați z × x alături de ambele.
error-parallel_tolerance_out_of_range = Toleranța pentru axe paralele este între { $least } și { $greatest } rad.
error-near_parallel = Axele { $previous } și { $joint } sunt paralele cu o abatere de { $angle } rad și au fost considerate paralele. Din această cauză ultimul sistem poate fi rotit cu cel mult dublul acestui unghi și deplasat cu cel mult { $displacement }.
error-near_parallel_dummy_row = Axele { $previous } și { $joint } sunt paralele cu o abatere de { $angle } rad; un rând fix între ele păstrează tabelul exact.
error-base_not_frame_zero_standard = Sistemul 0 al unui tabel standard are z de-a lungul axei 1 și originea pe ea; sistemul dat nu le are, deci se ajunge la el numai prin transformarea bazei.
error-base_not_frame_zero_modified = Sistemul 0 al unui tabel modificat are axa x care intersectează axa 1 în unghi drept; sistemul dat nu o are, deci se ajunge la el numai prin transformarea bazei.
error-tool_not_last_frame_standard = Ultimul sistem al unui tabel standard are axa x care intersectează ultima axă în unghi drept; scula dată nu o are, deci se ajunge la ea numai prin transformarea sculei.
error-tool_not_last_frame_modified = Ultimul sistem al unui tabel modificat are z de-a lungul ultimei axe și originea pe ea; scula dată nu le are, deci se ajunge la ea numai prin transformarea sculei.
