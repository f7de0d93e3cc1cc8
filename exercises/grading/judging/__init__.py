"""Is it right? From a table as it was typed to whether it is the key's robot: see `judgement`.

typed          how exactly an entry was typed, and what a rounded one stands for
ways           whether an answer is in names, in numbers, or in both
comparison     key and answer in numbers
name_values    the values at which they are compared
named_numbers  numbers that stand for names
digits         whether the lengths and angles typed are those of the key
end_lines      whether z_0 and z_N lie where the typed digits allow
judgement      whether it is right, in one way in which it may be meant
frames         how the frames of a right answer lie
certificate_report  the certificate, as it is told
exact_text     exact values as text
"""
