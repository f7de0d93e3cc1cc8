# Files of students, other systems' autograders, SCORM packages, receipts.

error-file_too_large =
    { $file } is larger than { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }; a table takes a few kilobytes.
error-file_missing = There is no file or folder { $file }.
error-grade_path_needed = A file, a folder or a zip archive is needed: standard input (-, or no argument) is read only with --for.
error-options_without_effect = { $options } would have no effect { $host ->
    [yes] with --for
   *[no] without --for
}.
error-marks_are_text = { $file } would not be a spreadsheet: grades are written as text, which spreadsheet programs read. Give the file a name that ends in .csv.
error-file_unreadable = { $file } cannot be read: { $reason ->
    [empty] it is empty
    [binary] it is not a text file
    [columns] its rows cannot be divided into columns; save it as CSV
    [UTF-16] it begins like UTF-16, but is not UTF-16 throughout; save it as UTF-8
   *[other] { $reason }
}.
error-file_unusable = { $file } cannot be read or written: { $reason }.
error-file_type_unknown = { $file } is of an unsupported type. Supported: { $known }.
error-file_without_table = { $file } holds no DH table. A table has the columns theta, d, a and alpha.
error-files_too_many = { $file } holds more than { $limit } files.
error-rows_too_many = { $file } has more than { $limit } rows. Divide it into several files.
error-columns_unknown = No row of { $file } names the columns { $known }. Write them above the table.
error-columns_repeated = The titles { $titles } of { $file } mean the same column. Write each column once; an offset of a joint belongs in its cell: q1 + 90.
error-units_differ = The titles of { $file } name two units for the same quantity: { $units }. Write all angles in one unit, and all lengths in one unit.
error-columns_differ_in_length = The columns of { $file } differ in length; each needs one entry for each row.
error-exercise_not_named = This does not say which exercise it answers. Name it, for example puma560.
error-artefact_unknown = Artefacts of type { $type } are not supported; { $known } are.
error-function_command_unknown = This command is not known. Known commands: { $known }.
error-function_call_invalid = The body of a call has `response`, `answer` and `params` (an object). Wrong at: { $places }.
error-callback_not_allowed = The operator of this service does not allow feedback to be sent to this address.
error-version_not_supported = This version of the evaluation API is not supported; { $supported } is.

error-api_key_unknown = There is no key { $id }.
error-key_file_unreadable = { $file } is not a usable key file: { $reason }.
error-receipt_kid_unknown = { $file } holds no key { $id }.
error-receipt_malformed = This is not a receipt, or not all of it. Copy it from its first character to its last.
error-receipt_key_unknown = The receipt was signed with a key that this service does not have. Ask the service that issued it.
error-receipt_altered = The receipt was changed after it was issued.

evaluation-right = Right
evaluation-wrong = Not right yet
evaluation-readable = The answer can be graded.
evaluation-unreadable = The answer cannot be graded as it stands; this costs no attempt.

scorm-no-script = This exercise needs JavaScript.
scorm-no-lms = No learning platform was found around this page. You can practise, but no grade will be recorded.

grade-summary = { $right } right, { $wrong } wrong, { $ungraded } not gradable.
grade-left-out = Files left out because of their type: { $count } ({ $files }).
