"""What is wrong? The smallest edits that mend a table: see `repairs`.

misconceptions  the catalogue: what students do, and how to undo it
wanted_changes  what of it is tried
cell_edits, row_edits, table_edits  the ways to undo it
throughout     units and digits, seen beside whatever else is wrong
changes        an edit: where, how much, and the table that it leads to
work, scope    what an edit is tried on, and what it has to do with
other_draws    the same edit at another draw of the parameters
fitting, joint_places  values and places that fit
last_row       the row that leads to the frame which is asked for
sieve          edits that are seen to fail, without measuring
trials, misfits  all edits at once, and what of the key each leaves missing
certainty      edits that are seen to mend the table, or not to, without a search
repairs        the smallest edits that mend the table
repaired       what is found: edits that mend it together
accused        which of them explain an answer: the likeliest, and what is as good
in_common      what equally small ones share
own_table      whether a table is the key's own
"""
