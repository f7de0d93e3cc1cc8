# Closed forms.

error-form_too_large = The expanded form needs more than { $limit } products of terms. Ask for fewer rows.
error-closed_form_too_large = Written out, a matrix has more than { $limit } operations. Ask for fewer rows, or for a function (python, c, matlab and others), which computes what is repeated only once.
error-closed_form_too_deep = An entry is nested too deeply for a JSON tree. Ask for text or LaTeX.
error-computation_out_of_time = This takes longer than { $seconds } s. Ask for fewer rows, parts or formats, or, in place of formulas, for numbers at given joint values.
error-computation_out_of_memory = This takes more memory than { $megabytes } MiB. Ask for fewer rows, parts or formats, or, in place of formulas, for numbers at given joint values.
error-computation_aborted = The computation was interrupted by a problem on the server, not by your request. Try again in a moment.
