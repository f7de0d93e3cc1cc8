# Antrenorul de sisteme de coordonate.

trainer-title = Antrenor de sisteme
trainer-heading = Atașați sistemele de coordonate
trainer-lead = Pentru fiecare sistem alegeți direcția lui z, originea și direcția lui x. Regulile se verifică pe parcurs, iar tabelul DH rezultă din sistemele alese.
trainer-back = Înapoi la exercițiu
trainer-frames = Sisteme de coordonate
trainer-table = Tabelul care rezultă
trainer-scene = Axe și sisteme
trainer-click = Faceți clic pe un punct sau pe o săgeată pentru a alege; listele fac același lucru.
trainer-clear = Golește acest sistem
trainer-next = Sistemul următor
trainer-complete = Toate sistemele respectă convenția: tabelul este complet.
trainer-unfinished = Un rând apare de îndată ce ambele sale sisteme sunt complete și nu încalcă nicio regulă.
trainer-status =
    { $broken ->
        [0] Nicio regulă încălcată până acum.
        [one] O regulă este încălcată.
        [few] { $broken } reguli sunt încălcate.
       *[other] { $broken } de reguli sunt încălcate.
    }
trainer-open = Deschide tabelul în atelier
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
trainer-candidate-base = ca în sistemul de bază dat
trainer-candidate-tool = ca în sistemul sculei dat
trainer-candidate-coordinates =
    { $axis ->
        [1] de-a lungul lui x al coordonatelor
        [2] de-a lungul lui y al coordonatelor
        [3] de-a lungul lui z al coordonatelor
       *[other] originea coordonatelor
    }
trainer-candidate-axis = de-a lungul axei { $axis }
trainer-candidate-normal = de-a lungul perpendicularei axelor { $axis } și { $other }
trainer-candidate-frame_x = de-a lungul lui x din sistemul { $frame }
trainer-candidate-across = perpendicular pe axa { $axis }
