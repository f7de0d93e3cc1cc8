"""Where work is done: threads, worker processes, and what goes on beside the requests.

fair_queue       slots for work, shared fairly between clients
limiters         threads behind such a queue
batcher, batches  what comes together is worked on together; long answers are sent while computed
workers          processes under limits on time and memory
processes, worker_process  one of them, as seen from outside, and its program
allotted_time    a list of tasks within a processor time
shared_answers   answers that every process gives alike
session_grading  judging what a signed-in student hands in
regrading_processes  judging stored attempts again
drawing_ahead    what will be asked for, read and drawn beforehand
  score_sender   scores to gradebooks
  settling       what follows from a regrading whose request was interrupted
  retention      what has been kept long enough is removed
callbacks        feedback sent later
heaps, collection  how the threads of a process share memory and take turns
"""
