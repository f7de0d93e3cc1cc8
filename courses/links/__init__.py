"""What a course asks, and by which rules.

link_settings  the rules of a link as JSON
course_links   links as they are stored
publications   exercises that were published, by content
"""
