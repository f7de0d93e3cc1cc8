"""Who takes part: platforms that launch, the people who arrive, their sessions and their rights.

platforms       platforms, their invitations, and the keys that this service signs with
enrolment       people, courses and links as a launch tells of them
sessions        who is signed in, by a token
administration  who administers the installation
secrets         tokens, pseudonyms, one-time codes, nonces
audit           what staff looked at or changed
privacy         all about one person, its erasure, and data that ends with time
"""
