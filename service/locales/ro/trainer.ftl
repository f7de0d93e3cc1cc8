# Antrenorul de sisteme de coordonate.

trainer-title = Exersarea sistemelor de coordonate
trainer-heading = Atașați sistemele de coordonate
trainer-lead = Sistem cu sistem, în ordinea în care se predă: toate axele z, perpendicularele comune, originile, toate axele x. Fiecare pas se verifică la sfârșit; apoi se citește tabelul DH.
trainer-back = Înapoi la exercițiu
trainer-frames = Sisteme de coordonate
trainer-table = Tabelul care rezultă
trainer-scene = Axe și sisteme
trainer-click = Apăsați pe o săgeată sau pe un punct, ori trageți-l, ca să-l alegeți; listele fac același lucru.
trainer-complete = Toate sistemele respectă convenția: tabelul este complet.
trainer-unfinished = Un rând apare de îndată ce ambele sale sisteme sunt complete și nu încalcă nicio regulă.
trainer-status =
    { $broken ->
        [0] Nicio regulă încălcată până acum.
        [one] O regulă este încălcată.
        [few] { $broken } reguli sunt încălcate.
       *[other] { $broken } de reguli sunt încălcate.
    }
trainer-step = Sistemul { $frame }: { $state }
trainer-state-open = neterminat
trainer-state-whole = complet
trainer-state-broken = încalcă o regulă
trainer-part-z = Direcția lui z, sistemul { $frame }
trainer-part-origin = Originea, sistemul { $frame }
trainer-part-x = Direcția lui x, sistemul { $frame }
trainer-opposite = opus:
trainer-candidate-foot = pe axa { $axis }, la piciorul perpendicularei pe axa { $other }
trainer-candidate-intersection = unde se întâlnesc axele { $axis } și { $other }
trainer-candidate-level = pe axa { $axis }, la nivelul originii sistemului { $frame }
trainer-candidate-axis_point = pe axa { $axis }, unde este desenată cupla
trainer-candidate-base = ca în sistemul bazei dat
trainer-candidate-tool = ca în sistemul sculei dat
trainer-candidate-coordinates =
    { $axis ->
        [1] de-a lungul axei X a figurii
        [2] de-a lungul axei Y a figurii
        [3] de-a lungul axei Z a figurii
       *[other] originea coordonatelor figurii
    }
trainer-candidate-axis = de-a lungul axei { $axis }
trainer-candidate-normal = de-a lungul perpendicularei comune a axelor { $axis } și { $other }
trainer-candidate-frame_x = de-a lungul lui x din sistemul { $frame }
trainer-candidate-across = perpendicular pe axa { $axis }

trainer-step-z = Axe z
trainer-step-normals = Perpendiculare comune
trainer-step-origin = Origini
trainer-step-x = Axe x
trainer-step-read = Citire
trainer-task-z = Alegeți pentru fiecare sistem direcția lui z. Ea este de-a lungul axei unei cuple; a căreia, depinde de convenție.
trainer-task-normals = Perpendicularele comune ale axelor vecine sunt desenate. Din ele rezultă originile și axele x.
trainer-task-origin = Alegeți originea fiecărui sistem. Perpendicularele comune sunt desenate.
trainer-task-x = Alegeți pentru fiecare sistem direcția lui x. Ea este de-a lungul perpendicularei comune spre următoarea axă z sau, unde axele se intersectează, perpendiculară pe ambele axe z.
trainer-normal-skew = Axele { $axis } și { $other } sunt necoplanare: au o singură perpendiculară comună, care este desenată.
trainer-normal-meet = Axele { $axis } și { $other } se intersectează: x este perpendiculară pe amândouă, iar originea este în punctul de intersecție.
trainer-normal-parallel = Axele { $axis } și { $other } sunt paralele sau coincid: orice perpendiculară comună este bună; alegeți-o pe cea care anulează d.
trainer-check = Verifică acest pas
trainer-onward = Continuă
trainer-restart = Începe din nou
trainer-step-done = Acest pas este corect.
trainer-why-z =
    Fiecare z este de-a lungul axei cuplei sale: { $convention ->
        [standard] axa z a sistemului i−1 de-a lungul axei i, deoarece rândul i rotește cu θ în jurul axei z a sistemului i−1 și deplasează cu d de-a lungul ei.
       *[modified] axa z a sistemului i de-a lungul axei i, deoarece rândul i se încheie cu θ în jurul axei z a sistemului i și cu d de-a lungul ei.
    }
trainer-why-origin = Fiecare origine este acolo unde perpendiculara comună întâlnește axa ei, deoarece de acolo se măsoară a de-a lungul lui x.
trainer-why-x = Fiecare x este pe o perpendiculară comună sau perpendiculară pe ambele axe, deoarece a și α se măsoară de-a lungul și în jurul ei.
trainer-open-choice = Sistemul { $frame } nu are încă o alegere.
trainer-point-missed = Originea sistemului { $frame } trebuie să fie în punctul marcat { $point }.
trainer-read = Apăsați numărul unui rând: imaginea arată cum cele patru numere duc un sistem în următorul.
trainer-take = Preia tabelul în exercițiu
