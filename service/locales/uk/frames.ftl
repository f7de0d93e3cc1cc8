# Призначення систем координат: правила й відмови.

rule-z_not_along_axis = z має лежати вздовж осі { $axis }.
rule-origin_not_on_axis = Початок має лежати на осі { $axis }.
rule-origin_not_on_common_normal = Початок має бути там, де спільний перпендикуляр осей { $first } і { $second } перетинає вісь цієї системи.
rule-origin_not_at_intersection = Осі { $first } і { $second } перетинаються: початок ставлять у точці перетину.
rule-x_not_across_z = x має бути перпендикулярною до z.
rule-x_not_along_common_normal = x має лежати вздовж спільного перпендикуляра осей { $first } і { $second }.
rule-x_not_across_both_axes = x має бути перпендикулярною до обох осей { $first } і { $second }.
rule-first_x_misses_axis = x першої системи має перетинати вісь { $axis } під прямим кутом.
rule-last_x_misses_axis = x останньої системи має перетинати вісь { $axis } під прямим кутом.
rule-z_reversed = z спрямована проти додатного напрямку осі { $axis }. Це дозволено; тоді змінна зчленування входить зі знаком мінус.
rule-x_reversed = x спрямована від осі { $second } до осі { $first }. Це дозволено; тоді довжина ланки стає від’ємною.
rule-offset_could_vanish = З іншим початком на цій осі d{ $joint } дорівнював би нулю.
rule-angle_could_vanish = З іншим напрямком x кут θ{ $joint } дорівнював би нулю.
rule-first_not_simplest = Систему 0 можна розташувати так, щоб зникло більше параметрів.
rule-last_not_simplest = Останню систему можна розташувати так, щоб зникло більше параметрів.

error-axes_wrong_number = У ланцюзі від 1 до { $limit } осей; у цьому їх { $count }.
error-axis_joint_unknown = Зчленування осі обертальне (revolute) або поступальне (prismatic).
error-gripper_jaws_along_approach = Губки рухаються впоперек напрямку підходу, а не вздовж нього.
error-vector_malformed = Задайте три скінченні числа x, y, z, не більші за { $limit }.
error-direction_zero = Напрямок мусить мати довжину: 0, 0, 0 нікуди не вказує.
error-frames_too_many = У ланцюга з { $count } зчленувань є системи від 0 до { $count }.
error-frame_y_not_z_cross_x = y випливає із z та x. Не вказуйте його або вкажіть z × x разом з обома.
error-parallel_tolerance_out_of_range = Допуск для паралельних осей лежить між { $least } і { $greatest } рад.
error-near_parallel = Осі { $previous } і { $joint } паралельні з точністю до { $angle } рад і були прийняті за паралельні; це зсуває робота щонайбільше на { $displacement }.
error-near_parallel_dummy_row = Осі { $previous } і { $joint } паралельні з точністю до { $angle } рад; нерухомий рядок між ними зберігає таблицю точною.
error-base_not_frame_zero_standard = Система 0 стандартної таблиці має z уздовж осі 1 і початок на ній; задана система — ні, тому вона пов’язана лише через основу.
error-base_not_frame_zero_modified = Система 0 модифікованої таблиці має вісь x, що перетинає вісь 1 під прямим кутом; задана система — ні, тому вона пов’язана лише через основу.
error-tool_not_last_frame_standard = Остання система стандартної таблиці має вісь x, що перетинає останню вісь під прямим кутом; заданий інструмент — ні, тому він пов’язаний лише через перетворення інструмента.
error-tool_not_last_frame_modified = Остання система модифікованої таблиці має z уздовж останньої осі й початок на ній; заданий інструмент — ні, тому він пов’язаний лише через перетворення інструмента.
