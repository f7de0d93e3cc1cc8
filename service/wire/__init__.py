"""From a validated request to the domain's objects, and from its results to what is sent.

kinematics                   robots, what is asked of them, and what is computed
exercises                    exercises, and answers of students
courses                      what students and lecturers are shown
fault_pointers               faults at their places in the request
answer_cache, json_chunks    kept, and written in pieces
"""
