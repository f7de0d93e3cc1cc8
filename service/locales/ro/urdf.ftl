# URDF și spațiul de lucru.

error-urdf_not_xml = Textul nu este XML bine format: linia { $line }, coloana { $column }.
error-urdf_unsafe = Un URDF nu are tip de document, nici entități și nu trimite la alte fișiere. Eliminați <!DOCTYPE …>.
error-urdf_too_long =
    Descrierea are mai mult de { $limit ->
        [one] { $limit } caracter
        [few] { $limit } caractere
       *[other] { $limit } de caractere
    }.
error-urdf_too_complex =
    Descrierea are mai mult de { $depth ->
        [one] { $depth } nivel
        [few] { $depth } niveluri
       *[other] { $depth } de niveluri
    } sau mai mult de { $elements ->
        [one] { $elements } element
        [few] { $elements } elemente
       *[other] { $elements } de elemente
    }.
error-urdf_no_robot = Elementul rădăcină este <{ $found }>; un URDF începe cu <robot>.
error-urdf_is_xacro = Acesta este xacro, un limbaj de macrouri. Expandați-l mai întâi: xacro robot.xacro > robot.urdf
error-urdf_no_links = Descrierea nu are elemente (link).
error-urdf_name_missing = Un element <{ $element }> nu are nume.
error-urdf_name_twice = Două elemente <{ $element }> se numesc „{ $name }”.
error-urdf_name_invalid = Un nume este un rând de caractere vizibile.
error-urdf_joint_incomplete = Cuplei „{ $joint }” îi lipsește <{ $element } link="…"/>.
error-urdf_link_missing = Cupla „{ $joint }” numește elementul „{ $link }”, pe care descrierea nu îl are.
error-urdf_link_unknown = Descrierea nu are elementul „{ $link }”; are { $known }.
error-urdf_links_alike = Primul element și ultimul au nevoie de nume diferite; ambele erau „{ $link }”.
error-urdf_two_parents = Elementul „{ $link }” este copilul a două cuple, „{ $first }” și „{ $second }”. Fiecare element are un singur părinte.
error-urdf_ring = Elementele formează o buclă prin „{ $link }”. O descriere este un arbore.
error-urdf_base_needed = Elemente fără părinte: { $count }. Indicați unul ca base_link: { $links }.
error-urdf_tip_needed = Descrierea se ramifică; capete: { $count }. Indicați unul ca tip_link: { $links }.
error-urdf_no_path = Nicio succesiune de cuple nu duce de la elementul „{ $base }” la elementul „{ $tip }”.
error-urdf_nothing_moves = Nimic nu se mișcă între elementul „{ $base }” și elementul „{ $tip }”.
error-urdf_too_many_joints =
    Lanțul are { $count ->
        [one] { $count } cuplă mobilă
        [few] { $count } cuple mobile
       *[other] { $count } de cuple mobile
    }; un tabel primește cel mult { $limit }.
error-urdf_several_freedoms = Cupla „{ $joint }” este de tip { $kind }: are mai multe grade de libertate, iar un rând al tabelului DH are unul.
error-urdf_type_unknown = Cupla „{ $joint }” este de tipul „{ $kind }”; tipurile cunoscute sunt { $known }.
error-urdf_mimic = Cupla „{ $joint }” se mișcă odată cu „{ $other }”, iar amândouă sunt în lanț; într-un tabel DH fiecare cuplă are propria variabilă.
error-urdf_mimic_unknown = Cupla „{ $joint }” o imită pe „{ $other }”, care nu este o cuplă a descrierii.
error-urdf_mimic_circle = Cupla „{ $joint }” nu are ce mișcare urma: ceea ce imită duce într-un cerc ({ $circle }).
error-urdf_attribute_unknown = Cupla „{ $joint }”: <{ $element }> nu are atributul „{ $attribute }”; primește { $known }.
error-urdf_element_twice = Cupla „{ $joint }” are mai multe elemente <{ $element }> diferite. Lăsați doar unul.
error-urdf_two_orientations = Cupla „{ $joint }” își dă orientarea de două ori, prin rpy și prin quat_xyzw. Lăsați doar una.
error-urdf_quaternion_zero = Cuaternionul cuplei „{ $joint }” este 0 0 0 0, ceea ce nu este o orientare.
error-urdf_joint_names =
    Un robot cu { $expected ->
        [one] { $expected } cuplă
        [few] { $expected } cuple
       *[other] { $expected } de cuple
    } primește tot atâtea nume, toate diferite și niciunul fixed_base, fixed_tool sau fixed_row_…; nume date: { $given }.
error-urdf_link_names =
    Un robot cu { $expected ->
        [one] { $expected } cuplă
        [few] { $expected } cuple
       *[other] { $expected } de cuple
    } primește tot atâtea nume de elemente (link), unul pentru ce poartă fiecare cuplă, toate diferite; nume date: { $given }.
error-urdf_axis_zero = Axa cuplei „{ $joint }” este 0 0 0 și nu are direcție.
error-urdf_limits_reversed = Limita inferioară a cuplei „{ $joint }” este mai mare decât cea superioară.
error-urdf_numbers_malformed = Cupla „{ $joint }”: { $attribute } din <{ $element }> primește { $count ->
        [one] un număr finit
       *[other] { $count } numere finite separate prin spații
    }, niciunul mai mare decât { $limit }.
error-urdf_limit_malformed = Cupla „{ $joint }”: { $attribute } din <limit> primește un număr. Scrieți inf dacă cupla nu are limită.
error-urdf_limit_overflow = O limită dintr-un URDF este de cel mult { $limit } (rad sau m) în valoare absolută. Dați null unde nu există limită.
error-urdf_length_overflow = Lungimile dintr-un URDF nu pot depăși { $limit_in_metres } m.
error-option_idle = Omiteți { $found }: această conversie nu îl folosește.

error-workspace_without_joints = Nimic nu se mișcă: un spațiu de lucru are nevoie de un rând de rotație sau de translație.
error-slide_without_limits = Cupla { $joint } se translatează: fără o valoare minimă și una maximă, spațiul de lucru este nelimitat.
