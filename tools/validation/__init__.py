"""What the folders of `validation/` share: running cases so that an interrupted campaign goes on where it stopped,
judging numbers against targets, and keeping both as results."""
