# Ce spune corectorul despre un tabel: despre unul corect, despre unul greșit și ce l-ar îndrepta.

## Un răspuns corect și cum stau sistemele lui față de cele ale rezolvării de referință

feedback-same_frames = Sistemele dumneavoastră sunt cele ale rezolvării de referință.
feedback-other_convention = Tabelul dumneavoastră este scris în convenția { $convention ->
    [modified] modificată, iar rezolvarea de referință în cea standard
   *[standard] standard, iar rezolvarea de referință în cea modificată
}; amândouă descriu același robot.
feedback-axis_reversed = Axa z{ $frame }, adică axa cuplei { $joint }, are la dumneavoastră sensul opus celui din rezolvarea de referință. Ambele sensuri sunt corecte, iar semnele din tabel se potrivesc cu alegerea dumneavoastră.
feedback-end_axis_reversed = Axa z{ $frame } are la dumneavoastră sensul opus celui din rezolvarea de referință. Ambele sensuri sunt corecte.
feedback-x_turned = Axa x{ $frame } este rotită cu { $degrees }° în jurul lui z{ $frame } față de rezolvarea de referință. Tabelul dumneavoastră ține seama de aceasta.
feedback-origin_slid = Originea sistemului { $frame } se află în alt loc de pe axa z{ $frame } decât în rezolvarea de referință. Aici orice loc este corect.
feedback-axis_moved = Axa z{ $frame } se află pe altă dreaptă, paralelă cu cea din rezolvarea de referință. Aici contează numai direcția ei.
feedback-frame_elsewhere = Sistemul { $frame } este plasat altfel decât în rezolvarea de referință. Alegerea lui vă aparținea.
feedback-variable_reversed = Variabila q{ $joint } are la dumneavoastră sensul opus celui din rezolvarea de referință. Ambele sensuri sunt corecte.
feedback-variable_offset = Acolo unde q{ $joint } din rezolvarea de referință este zero, variabila dumneavoastră are valoarea { $offset }. Poziția de zero a unei variabile se alege liber.
feedback-rounded = Valorile din tabel coincid cu rezolvarea de referință în limita toleranței, nu exact; probabil au fost rotunjite.

## Un răspuns greșit: ansamblul

feedback-not_equivalent = Tabelul dumneavoastră nu descrie acest robot, oricum s-ar alege sistemele de coordonate.
feedback-right_robot = Tabelul dumneavoastră descrie robotul potrivit, dar nu respectă tot ce cere exercițiul.
feedback-not_accepted = Tabelul dumneavoastră nu respectă tot ce cere exercițiul.
feedback-convention_not_asked = Exercițiul cere convenția { $asked ->
    [modified] modificată
   *[standard] standard
}; tabelul dumneavoastră este scris în cea { $given ->
    [modified] modificată
   *[standard] standard
}.
feedback-joint_count_wrong = { $given ->
    [0] Tabelul dumneavoastră nu are nicio cuplă
    [one] Tabelul dumneavoastră are o cuplă
    [few] Tabelul dumneavoastră are { $given } cuple
   *[other] Tabelul dumneavoastră are { $given } de cuple
}; robotul are { $asked }.
feedback-mirrored = Tabelul dumneavoastră descrie imaginea în oglindă a robotului: toate lungimile și unghiurile se potrivesc, dar una dintre ele este luată în sens invers. Verificați semnele cu regula mâinii drepte.
feedback-entries_imprecise = Nicio lungime și niciun unghi din tabel nu diferă mai mult decât explică rotunjirea, dar rotunjirile depășesc împreună toleranța exercițiului. Scrieți unghiurile exact, ca pi/2 sau 90°, și lungimile cu mai multe cifre.
feedback-lengths_rounded = Mai multe lungimi din tabel au valoarea corectă, dar cu prea puține cifre. Scrieți-le cu mai multe cifre; celelalte greșeli semnalate aici nu vin din rotunjire.
feedback-base_axis_missed = Axa z0 nu este pe axa cuplei 1.
feedback-base_origin_missed = Originea sistemului 0 nu se află unde o cere exercițiul.
feedback-base_frame_missed = Sistemul 0 nu este cel impus de exercițiu.
feedback-tool_point_missed = Originea ultimului sistem nu se află în punctul marcat.
feedback-tool_axis_missed = Axa z a ultimului sistem nu este pe axa ultimei cuple.
feedback-tool_frame_missed = Ultimul sistem nu este cel impus de exercițiu.
feedback-zero_missed = În configurația din figură toate variabilele cuplelor ar trebui să fie zero; ale dumneavoastră nu sunt.
feedback-direction_missed = Variabilele cuplelor ar trebui să crească în sensul săgeților din figură; nu toate variabilele dumneavoastră cresc astfel.
feedback-whole_table = O singură greșeală se repetă în tot tabelul.
feedback-columns_throughout = Coloanele a și α nu se potrivesc cu convenția pe care o declară tabelul.
feedback-columns_in_disorder = Coloanele din tabel sunt în altă ordine.
feedback-angles_throughout = Unghiurile din tabel nu sunt în unitatea declarată.
feedback-lengths_throughout = Lungimile din tabel nu sunt în unitatea declarată.
feedback-turns_throughout = Unghiurile cuplelor cresc peste tot în sensul greșit.
feedback-twists_throughout = Unghiurile α au peste tot semnul greșit.
feedback-twists_out_of_place = Unghiurile α din tabel nu sunt în rândurile la care aparțin.
feedback-names_throughout = O cotă poartă în tabel un nume greșit.
feedback-parameter_unknown = Robotul nu are nicio cotă cu numele { $name }. Cotele lui sunt: { $known }.
feedback-names_asked = Cotele robotului nu au valori aici. Scrieți numele lor: { $known }.

## Un răspuns greșit: rândurile

feedback-one_of_these = Doar una dintre observațiile următoare este greșeala; tabelul singur nu arată care.
feedback-row_wrong = Rândul { $row } nu este corect.
feedback-twist_wrong = Rândul { $row }: unghiul de torsiune α, de la z{ $before } la z{ $row }, nu este corect.
feedback-length_wrong = Rândul { $row }: lungimea a, distanța de la z{ $before } la z{ $row }, nu este corectă.
feedback-offset_wrong = Rândul { $row }: decalajul d, distanța de la x{ $before } la x{ $row } măsurată de-a lungul lui z, nu este corect.
feedback-angle_wrong = Rândul { $row }: unghiul θ, de la x{ $before } la x{ $row } în jurul lui z, nu este corect.
feedback-sign_wrong = Rândul { $row }: un semn este luat invers. Verificați: { $cells }.
feedback-joint_type_wrong = Rândul { $row }: tipul cuplei nu este corect.
feedback-variable_zero_wrong = Rândul { $row }: în configurația din figură, variabila cuplei nu este zero.
feedback-variable_direction_wrong = Rândul { $row }: variabila cuplei crește în sens contrar săgeții din figură.
feedback-row_missing = Lipsește un rând { $after ->
    [0] înaintea rândului 1
   *[other] după rândul { $after }
}.
feedback-row_not_needed = Rândul { $row } este în plus.
feedback-rows_out_of_order = Rândurile { $row } și { $other } sunt în ordine greșită.

## Ce l-ar face corect

repair-convention = Citit în convenția { $meant ->
    [modified] modificată
   *[standard] standard
}, tabelul ar fi corect; dumneavoastră ați declarat-o pe cea { $declared ->
    [modified] modificată
   *[standard] standard
}.
repair-angles_in_degrees = Unghiurile sunt în grade, dar tabelul declară radiani.
repair-angles_in_radians = Unghiurile sunt în radiani, dar tabelul declară grade.
repair-length_unit = Lungimile sunt în altă unitate decât cea declarată: de exemplu, milimetri în loc de metri.
repair-columns_late = Coloanele a și α sunt cu un rând prea jos, ca în cealaltă convenție. Cărui element îi corespunde fiecare rând?
repair-columns_early = Coloanele a și α sunt cu un rând prea sus, ca în cealaltă convenție. Cărui element îi corespunde fiecare rând?
repair-twists_late = Coloana α este cu un rând prea jos; a este la locul ei. Într-un rând, a și α aparțin aceluiași element.
repair-twists_early = Coloana α este cu un rând prea sus; a este la locul ei. Într-un rând, a și α aparțin aceluiași element.
repair-columns_exchanged = Coloanele { $one } și { $other } sunt schimbate între ele. Comparați ordinea coloanelor cu cea din notițe.
repair-columns_reordered = Ce stă sub α ține de { $alpha }, ce stă sub a ține de { $a }, iar ce stă sub d ține de { $d }. Comparați ordinea coloanelor cu cea din notițe.
repair-parameter_misnamed = { $name } nu este o cotă a acestui robot. La care cotă din figură vă referiți?
repair-parameters_swapped = { $name } și { $other } sunt schimbate între ele. Comparați-le cu figura.
repair-alpha_sign = Rândul { $row }: α are semnul greșit. Rotiți z{ $before } peste z{ $row } în jurul lui x, după regula mâinii drepte.
repair-alpha_value = Rândul { $row }: α are o valoare greșită. Priviți din nou cum stau z{ $before } și z{ $row } una față de alta.
repair-turns_all_reversed = Toate unghiurile cuplelor cresc în sensul greșit. Rotiți în jurul lui z cu mâna dreaptă, nu cu stânga.
repair-twists_all_reversed = Toate unghiurile α au semnul greșit. Rotiți o axă z peste următoarea în jurul lui x cu mâna dreaptă, nu cu stânga.
repair-a_sign = Rândul { $row }: a are semnul greșit. Se măsoară în sensul lui x.
repair-d_sign = Rândul { $row }: d are semnul greșit. Se măsoară în sensul lui z.
repair-twists_swapped = Rândurile { $row } și { $other }: valorile lui α sunt schimbate între ele.
repair-a_d_swapped = Rândul { $row }: a și d sunt schimbate între ele. a se măsoară de-a lungul lui x, d de-a lungul lui z.
repair-a_value = Rândul { $row }: a are o valoare greșită. Măsurați pe perpendiculara comună a axelor z{ $before } și z{ $row }.
repair-a_missing = Rândul { $row }: a nu ar trebui să fie zero, deoarece z{ $before } și z{ $row } nu se intersectează.
repair-a_not_zero = Rândul { $row }: a ar trebui să fie zero, deoarece z{ $before } și z{ $row } se intersectează sau coincid.
repair-d_value = Rândul { $row }: d are o valoare greșită. Măsurați de-a lungul lui z, de la x{ $before } la x{ $row }.
repair-d_missing = Rândul { $row }: a fost omis decalajul d de-a lungul lui z, de la x{ $before } la x{ $row }.
repair-d_not_zero = Rândul { $row }: d ar trebui să fie zero, deoarece x{ $before } și x{ $row } întâlnesc axa z în același punct.
repair-cell_length_unit = Rândul { $row }: o lungime este în altă unitate decât celelalte.
repair-cell_parameter = Rândul { $row }: aici stă altă cotă din figură.
repair-cell_in_degrees = Rândul { $row }: un unghi este în grade, dar tabelul declară radiani.
repair-cell_in_radians = Rândul { $row }: un unghi este în radiani, dar tabelul declară grade.
repair-theta_value = Rândul { $row }: unghiul constant θ are o valoare greșită. Rotiți x{ $before } peste x{ $row } în jurul lui z.
repair-theta_offset = Rândul { $row }: la θ trebuie adunată la variabilă altă constantă, astfel încât variabila să fie zero în configurația din figură.
repair-d_offset = Rândul { $row }: la d trebuie adunată la variabilă altă constantă, astfel încât variabila să fie zero în configurația din figură.
repair-variable_sign = Rândul { $row }: variabila cuplei are sensul greșit. Dați-i semnul opus.
repair-joint_type = Rândul { $row }: această cuplă { $joint_type ->
    [prismatic] este de translație; variabila ei stă la d
   *[revolute] este de rotație; variabila ei stă la θ
}.
repair-joint_fixed = Rândul { $row }: această cuplă se mișcă; variabila ei lipsește.
repair-joint_moving = Rândul { $row }: aici nu se mișcă nimic; rândul are numai constante.
repair-rows_swapped = Rândurile { $row } și { $other } sunt schimbate între ele.
repair-fixed_row_missing = Lipsește un ultim rând fără variabilă: cel care duce de la ultima cuplă la punctul marcat sau la ultimul sistem impus.
repair-row_missing = Lipsește un rând { $after ->
    [0] înaintea rândului 1
   *[other] după rândul { $after }
}.
repair-row_extra = Rândul { $row } este în plus.

## Refuzat

error-tables_without_value = Nu s-au găsit valori ale parametrilor pentru care fiecare celulă a ambelor tabele să aibă o valoare. Verificați radicalii, rapoartele și funcțiile inverse.

feedback-frame_wrong = Sistemul { $frame } încalcă o regulă.
feedback-frame_missing = Sistemul { $frame } nu a fost așezat.
feedback-frame_z_not_along_axis = Sistemul { $frame }: { rule-z_not_along_axis }
feedback-frame_origin_not_on_axis = Sistemul { $frame }: { rule-origin_not_on_axis }
feedback-frame_origin_not_on_common_normal = Sistemul { $frame }: { rule-origin_not_on_common_normal }
feedback-frame_origin_not_at_intersection = Sistemul { $frame }: { rule-origin_not_at_intersection }
feedback-frame_x_not_across_z = Sistemul { $frame }: { rule-x_not_across_z }
feedback-frame_x_not_along_common_normal = Sistemul { $frame }: { rule-x_not_along_common_normal }
feedback-frame_x_not_across_both_axes = Sistemul { $frame }: { rule-x_not_across_both_axes }
feedback-frame_first_x_misses_axis = Sistemul { $frame }: { rule-first_x_misses_axis }
feedback-frame_last_x_misses_axis = Sistemul { $frame }: { rule-last_x_misses_axis }
feedback-frames_other_convention = Aceste sisteme respectă regulile celeilalte convenții.
feedback-frames_not_as_asked = Sistemele respectă regulile, dar nu sunt așezate cum cere exercițiul.
feedback-frames_right = Sistemele sunt corecte.
feedback-repairs_one_cell = Sunt mai multe schimbări posibile și oricare dintre ele ar corecta tabelul; toate sunt în celula { $cell ->
    [alpha] α
    [theta] θ
   *[other] { $cell }
} din rândul { $row }.
feedback-repairs_one_row = Sunt mai multe schimbări posibile și oricare dintre ele ar corecta tabelul; toate sunt în rândul { $row }.
feedback-repairs_one_column = Sunt mai multe schimbări posibile și oricare dintre ele ar corecta tabelul; toate sunt în coloana { $cell ->
    [alpha] α
    [theta] θ
   *[other] { $cell }
}.
feedback-repairs_one_kind =
    Sunt { $count ->
        [one] { $count } schimbare
        [few] { $count } schimbări
       *[other] { $count } de schimbări
    } posibile și oricare dintre ele ar corecta tabelul; toate sunt de același fel.
