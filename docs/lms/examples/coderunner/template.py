# CodeRunner question: type "python3", template as a combinator, grader "Template grader".
# The student's answer is a table with a header row (theta, d, a, alpha) or JSON.
import subprocess
import sys

answer = """{{ STUDENT_ANSWER | e('py') }}"""
command = [
    sys.executable,
    "-m",
    "service",
    "grade",
    "--for",
    "coderunner",
    "--exercise",
    "twolink",
    "--angle-unit",
    "deg",
]
print(subprocess.run(command, input=answer.encode(), capture_output=True, check=True).stdout.decode())
