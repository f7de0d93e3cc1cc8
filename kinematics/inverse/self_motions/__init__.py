"""Solutions that are joined by a path: families of them, and which ones stand alone.

isolation      which solutions stand alone, in one pass
components     which solutions stand alone, and which families there are
membership     which solutions belong to a family
corrections    from beside a family back to it
families       families, and what is counted while they are followed
paths          families followed along their paths
weights        distance weighed against angle where a target is missed by both
walks          ways from one solution to another
crossings      where families cross others
gaps           families in pieces
ranges         families within joint limits
"""
