### Courses, stored attempts and launches from a learning management system: what is refused, and why.

problem-title-401 = Not signed in
problem-title-403 = Not allowed
problem-title-409 = Not possible now

## Storage

error-storage_folder = The data folder { $folder } cannot be used: { $reason }. Set FRAMEWISE_DATA_FOLDER to a folder that can be written, or FRAMEWISE_STORAGE to off.
error-storage_address = FRAMEWISE_DATABASE_URL does not name a PostgreSQL database. It looks like postgresql://user:password@host/database.
error-storage_unusable = The database { $location } cannot be used: { $reason }.
error-storage_unavailable = The database does not answer just now. What was confirmed before is safe. Send this again in a few seconds.
error-storage_missing = There is no database at { $location }. FRAMEWISE_DATA_FOLDER or FRAMEWISE_DATABASE_URL should name the one of the service.
error-schema_newer = The data was written by a newer version of the program (schema { $found }; this version knows { $known }). Install the newer version.
error-storage_not_empty = A backup is restored into an empty database only; the relation { $table } holds rows already.
error-backup_unreadable = { $file } cannot be read or written as a backup: { $reason }.

## Attempts

error-record_unknown = { $kind ->
    [attempt] There is no such attempt in this course.
    [person] There is no such person in this course.
    [anybody] There is no such person here.
    [several] Several pseudonyms begin like this. Give more characters of it; an export shows the whole of it.
    [link] There is no such link in this course.
    [platform] There is no such platform.
    [course] There is no such course.
   *[other] There is no such record in this course.
}
error-attempts_not_open = Attempts open on { TIME($opens) } UTC.
error-attempts_closed = The exercise closed on { TIME($closes) } UTC.
error-attempts_used = { $allowed ->
    [one] The one attempt that this exercise allows has been made.
   *[other] All { $allowed } attempts that this exercise allows have been made.
}
error-exercise_changed = The exercise was changed after you opened this page, and nothing was handed in. Reload the page: what you typed is still there.
error-settings_changed = Your changes were not saved: somebody else has saved other rules since you opened this page. Reload the page and look at them.
error-regrading_outdated = Nothing was applied: the exercise or the rules of the link have changed since these scores were computed, or other scores have been applied. Regrade again.
error-scores_unsent = { $count ->
    [one] Nothing was removed: the gradebook has not received { $count } score of this course. See what keeps it; to lose it, add --with-unsent.
   *[other] Nothing was removed: the gradebook has not received { $count } scores of this course. See what keeps them; to lose them, add --with-unsent.
}
error-setting_invalid = { $name } can be: { $known }.
error-closes_before_opening = The exercise would close before it opens.
error-session_expired = You are no longer signed in. What you typed is still here: open the exercise from your course again.
error-administrator_unknown = This page is opened with an address that framewise lti administer prints. The address works once, within ten minutes; you stay signed in for two hours.
error-code_used = This address has been used already. Open the exercise from your course again.
error-staff_only = This is open to the staff of the course.
error-publishing_closed =
    { $who ->
        [staff] Exercises can be published here only by those who came from a course as its staff, or with a key that has the scope publish.
        [key] Exercises can be published here only with a key that has the scope publish.
       *[nobody] Nobody can publish exercises on this service.
    }
error-link_without_exercise = No exercise has been chosen for this link yet. A teacher chooses it by opening the link.
error-invitation_used = This registration address has been used already, or is too old. Ask for a new one.
error-storage_off = This installation keeps no courses: its storage is switched off.
error-posted_form_too_large =
    The form is larger than { $limit ->
        [one] { $limit } byte
       *[other] { $limit } bytes
    }.
error-form_invalid = The body is not a form (application/x-www-form-urlencoded).
