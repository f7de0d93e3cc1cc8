"""LTI 1.3 Advantage, the tool's side: launches, keys, deep links, scores, memberships, registration.

The protocol alone: it knows no course, no exercise and no database. What must be remembered (states, nonces,
keys, platforms) is handed in. Specifications: 1EdTech Security Framework 1.1 §5.1, LTI 1.3, Deep Linking 2.0,
Assignment and Grade Services 2.0, Names and Role Provisioning Services 2.0, Dynamic Registration 1.0,
Client-Side postMessages 0.1, Platform Storage 0.1.
"""
