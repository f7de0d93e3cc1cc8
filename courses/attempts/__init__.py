"""What was typed and handed in.

stored_attempts  attempts and drafts as they are stored; the codes of a report
submissions      judged submissions become attempts, many in one transaction, with the grades that follow
"""
