"""What was typed and handed in.

stored_attempts  attempts and drafts as they are stored
report_codes     what a report tells, as codes for statistics
submissions      judged submissions become attempts, many in one transaction, with the grades that follow
"""
