# Cómo las fuerzas mueven un robot.

error-links_count = La lista de eslabones tiene una entrada por cada fila de la tabla: { $expected }, no { $given }.
error-mass_negative = Una masa no es negativa: { $mass } kg.
error-inertia_not_symmetric = Una matriz de inercia es simétrica: el elemento xy es igual al yx.
error-inertia_negative = Un momento de inercia respecto de un eje nunca es negativo. Esta matriz tiene uno negativo respecto de algún eje.
error-mass_matrix_singular = Alguna articulación no mueve nada que tenga masa, así que ninguna fuerza determina su aceleración. Dé masa e inercia a los eslabones.
error-links_missing = Indique la masa de los eslabones: links, una entrada por cada fila de la tabla.
error-name_of_rate = { $name } es el nombre de la velocidad de una articulación en las formas cerradas. Llame al parámetro de otro modo.
error-body_varies = La masa de un eslabón y su lugar no cambian con las variables articulares: estas solo figuran en la tabla.
error-dynamics_not_finite = Las masas, longitudes o velocidades son tan grandes que el resultado no es un número.
