# Metoda SCM: lanțuri de rânduri [X Y Z A B C].

error-scm_chain_empty = Lanțul nu are nicio cuplă. Este nevoie de cel puțin un rând.
error-scm_too_many_joints =
    Lanțul are { $joints ->
        [one] { $joints } cuplă
        [few] { $joints } cuple
       *[other] { $joints } de cuple
    }; se citesc cel mult { $limit }.
error-scm_chain_too_long =
    Elementele au împreună { $length ->
        [one] { $length } caracter
        [few] { $length } caractere
       *[other] { $length } de caractere
    }; se citesc cel mult { $limit }.
error-scm_no_variable = Rândul { $joint } nu conține nicio variabilă de cuplă. Scrieți q{ $joint } în elementul care se mișcă.
error-scm_two_variables = Rândul { $joint } își conține variabila și în { $first }, și în { $second }. Un rând are exact una.
error-scm_variable_of_other_row = { $name } nu este variabila rândului { $joint }; aceasta este q{ $joint }.
error-scm_variable_form = Variabila trebuie să apară ca +q{ $joint } sau −q{ $joint }, la care se adună cel mult o constantă.
error-scm_variable_outside_joints = { $name } este o variabilă de cuplă; numai rândurile cuplelor pot conține una.
error-scm_parameter_two_kinds = { $name } măsoară o lungime într-un element și un unghi în altul. Folosiți două nume.
error-scm_prismatic_turns = Cupla { $joint } este de translație: rândul ei nu poate roti sistemul de coordonate. Puneți rotațiile constante în transformarea finală.
error-scm_prismatic_second_length = Cupla { $joint } este de translație: rândul ei conține variabila și nicio altă lungime. Puneți această lungime într-un rând dinainte sau de după.
error-scm_revolute_offset = Cupla { $joint } este de rotație: unghiul ei nu poate conține o constantă adunată. Puneți rotațiile constante în transformarea finală.
error-scm_revolute_second_turn = Cupla { $joint } se rotește în jurul unei singure axe. Puneți rotațiile constante în transformarea finală.
error-scm_limits_reversed = Cupla { $joint }: limitele sunt [inferioară, superioară], ambele finite; cea inferioară nu o depășește pe cea superioară.
error-chain_or_robot = Dați exact unul dintre cele două: chain sau robot.
error-scm_six_entries = Sunt necesare șase intrări: lista [X, Y, Z, A, B, C] sau un obiect cu unele dintre x, y, z, a, b, c; ce lipsește este 0.
error-matrix_not_rotation = Partea de rotație a acestei matrice nu este o rotație: coloanele ei trebuie să fie versori perpendiculari, într-un triedru drept, pentru toate valorile variabilelor de cuplă. Numai atunci are viteză unghiulară.
error-variable_name_invalid = { $name } nu poate fi numele variabilei de cuplă { $joint }: un nume este un cuvânt cu un indice, ca a1, și fiecare variabilă îl are pe al ei.
error-no_derivative = O variabilă de cuplă apare într-o funcție care nu se derivează aici: scrieți sinusuri și cosinusuri ale ei.
