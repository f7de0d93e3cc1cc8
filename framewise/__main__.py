"""`python -m framewise` is `framewise`."""

from service.__main__ import main

main()
