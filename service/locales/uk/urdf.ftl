# URDF і робоча зона.

error-urdf_not_xml = Текст не є правильно побудованим XML: рядок { $line }, стовпець { $column }.
error-urdf_unsafe = URDF не має типу документа й сутностей і не посилається на інші файли. Вилучіть <!DOCTYPE …>.
error-urdf_too_long =
    Опис довший за { $limit ->
        [one] { $limit } символ
        [few] { $limit } символи
       *[other] { $limit } символів
    }.
error-urdf_too_complex =
    В описі понад { $depth ->
        [one] { $depth } рівень
        [few] { $depth } рівні
       *[other] { $depth } рівнів
    } вкладення або понад { $elements ->
        [one] { $elements } елемент
        [few] { $elements } елементи
       *[other] { $elements } елементів
    }.
error-urdf_no_robot = Кореневий елемент — <{ $found }>; URDF починається з <robot>.
error-urdf_is_xacro = Це xacro, мова макросів. Спершу розгорніть його: xacro robot.xacro > robot.urdf
error-urdf_no_links = В описі немає ланок (link).
error-urdf_name_missing = Елемент <{ $element }> не має імені.
error-urdf_name_twice = Два елементи <{ $element }> мають ім’я «{ $name }».
error-urdf_name_invalid = Назва — один рядок видимих символів.
error-urdf_joint_incomplete = Зчленуванню «{ $joint }» бракує <{ $element } link="…"/>.
error-urdf_link_missing = Зчленування «{ $joint }» називає ланку «{ $link }», якої в описі немає.
error-urdf_link_unknown = В описі немає ланки «{ $link }»; є { $known }.
error-urdf_links_alike = Перша й остання ланки мають мати різні назви; обидві були «{ $link }».
error-urdf_two_parents = Ланка «{ $link }» є нащадком двох зчленувань, «{ $first }» і «{ $second }». Кожна ланка має одного предка.
error-urdf_ring = Ланки утворюють замкнений цикл через «{ $link }». Опис має бути деревом.
error-urdf_base_needed = Ланок без предка: { $count }. Укажіть одну як base_link: { $links }.
error-urdf_tip_needed = Опис розгалужується; кінців: { $count }. Укажіть один як tip_link: { $links }.
error-urdf_no_path = Жодні зчленування не ведуть від ланки «{ $base }» до ланки «{ $tip }».
error-urdf_nothing_moves = Між ланкою «{ $base }» і ланкою «{ $tip }» ніщо не рухається.
error-urdf_too_many_joints = Рухомих зчленувань у ланцюзі: { $count }; таблиця приймає щонайбільше { $limit }.
error-urdf_several_freedoms = Зчленування «{ $joint }» має тип { $kind }: у нього кілька степенів вільності, а в рядка таблиці DH — один.
error-urdf_type_unknown = Зчленування «{ $joint }» має тип «{ $kind }»; відомі типи: { $known }.
error-urdf_mimic = Зчленування «{ $joint }» рухається разом з «{ $other }», і обидва належать до ланцюга; у таблиці DH кожне зчленування має власну змінну.
error-urdf_mimic_unknown = Зчленування «{ $joint }» повторює рух «{ $other }», якого в описі немає.
error-urdf_mimic_circle = Зчленуванню «{ $joint }» нема за чим рухатися: те, що воно повторює, замикається в коло ({ $circle }).
error-urdf_attribute_unknown = Зчленування «{ $joint }»: елемент <{ $element }> не має атрибута «{ $attribute }»; допустимі: { $known }.
error-urdf_element_twice = Зчленування «{ $joint }» має кілька різних елементів <{ $element }>. Залиште щось одне.
error-urdf_two_orientations = Зчленування «{ $joint }» задає орієнтацію двічі: через rpy і через quat_xyzw. Залиште щось одне.
error-urdf_quaternion_zero = Кватерніон зчленування «{ $joint }» — 0 0 0 0, це не орієнтація.
error-urdf_joint_names = Назв зчленувань має бути стільки ж, скільки зчленувань у робота: { $expected }, усі різні, і жодна не fixed_base, fixed_tool чи fixed_row_…; задано: { $given }.
error-urdf_link_names = Назв ланок має бути стільки ж, скільки зчленувань у робота: { $expected }, по одній на те, що несе кожне зчленування, і всі різні; задано: { $given }.
error-urdf_axis_zero = Вісь зчленування «{ $joint }» — 0 0 0, вона не має напряму.
error-urdf_limits_reversed = Нижня межа зчленування «{ $joint }» більша за верхню.
error-urdf_numbers_malformed = Зчленування «{ $joint }»: { $attribute } у <{ $element }> приймає скінченні числа через пропуск (кількість: { $count }), не більші за { $limit }.
error-urdf_limit_malformed = Зчленування «{ $joint }»: { $attribute } у <limit> приймає одне число. Напишіть inf, якщо межі немає.
error-urdf_limit_overflow = Межа в URDF за модулем не перевищує { $limit } (рад або м). Де межі немає, вкажіть null.
error-urdf_length_overflow = Довжини в URDF не можуть перевищувати { $limit_in_metres } м.
error-option_idle = Приберіть { $found }: це перетворення його не використовує.

error-workspace_without_joints = Ніщо не рухається: робоча зона потребує обертального або поступального рядка.
error-slide_without_limits = Зчленування { $joint } поступальне: без найменшого й найбільшого значень робоча зона необмежена.
