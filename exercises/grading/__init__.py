"""Grading: from two tables and a policy to a verdict; see `grade`.

grade            the whole of it
verdict          what is said of a table; `verdict_html` in notebooks
certificate_report  the certificate in it
Is it right?
  typed          how exactly an entry was typed, and what a rounded one stands for
  comparison     key and answer in numbers
  name_values    the values at which they are compared
  named_numbers  numbers that stand for names
  digits         whether the lengths and angles typed are those of the key
  judgement      whether it is right, in one way in which it may be meant
  frames         how the frames of a right answer lie
  exact_text     exact values as text
What is wrong?
  explanation    what is told, and what is earned
  misconceptions  the catalogue: what students do, and how to undo it; `wanted_changes` what of it is tried
  cell_edits, row_edits, table_edits  the ways to undo it
  changes        an edit: where, how much, and the table that it leads to
  work           what an edit is tried on
  fitting, joint_places  values and places that fit
  last_row       the row that leads to the frame which is asked for
  sieve          edits that are seen to fail, without measuring
  trials         all edits at once
  repairs        the smallest edits that mend the table; `in_common` what equally small ones share
  own_table      whether a table is the key's own
  findings       what is said, by level of help
  facts, score   which facts of the robot are right, and what they earn
"""

from exercises.grading.grade import accept, grade, is_accepted
from exercises.grading.verdict import (
    Basis,
    CertificateReport,
    Edit,
    ExactForms,
    Feedback,
    Finding,
    HelpLevel,
    LinkFinding,
    Repair,
    Verdict,
)
from kinematics.equivalence import (
    BaseRule,
    ConventionRule,
    DirectionRule,
    Policy,
    Tolerance,
    ToolRule,
    ZeroRule,
)

__all__ = [
    "BaseRule",
    "Basis",
    "CertificateReport",
    "ConventionRule",
    "DirectionRule",
    "Edit",
    "ExactForms",
    "Feedback",
    "Finding",
    "HelpLevel",
    "LinkFinding",
    "Policy",
    "Repair",
    "Tolerance",
    "ToolRule",
    "Verdict",
    "ZeroRule",
    "accept",
    "grade",
    "is_accepted",
]
