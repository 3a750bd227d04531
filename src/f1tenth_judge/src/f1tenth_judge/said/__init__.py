"""What planners say besides their commands: drawings, numbers, pictures."""
