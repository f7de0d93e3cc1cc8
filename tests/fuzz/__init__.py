"""Whatever strangers send: bytes to every reader, with its own refusals and nothing else.

targets    one function for each kind of input: it raises only what the reader says it raises
mutating   inputs from the corpus, changed at random: what is used where atheris is not installed
__main__   a campaign, guided by coverage where atheris is installed (`make fuzz MINUTES=10`)
corpus     a few small inputs for each target, and whatever was once found
"""
