"""What attempts come to.

judged      attempts with the judgement that counts: their own, or that of the last regrading
gradebook   the grade of each student, and what the platform has to hear of it
outbox      scores on their way to the platform
"""
