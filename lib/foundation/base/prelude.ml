let ( let* ) = Result.bind
