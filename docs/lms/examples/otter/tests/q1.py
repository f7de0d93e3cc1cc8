"""Otter tests of question 1: all the points for a right table, some for one that has facts of the robot right."""

from otter.test_files import test_case

OK_FORMAT = False
name = "q1"
points = 5


@test_case(points=2, hidden=False)
def test_the_table_can_be_graded(table):
    from framewise import check

    assert check(table, "twolink").gradable


@test_case(points=3, hidden=False)
def test_the_table_describes_the_robot(table):
    from framewise import check

    checked = check(table, "twolink")
    assert checked.correct, str(checked)
