let ( let* ) = Result.bind
let ( let*? ) = Option.bind
let ( <?> ) c next = if c <> 0 then c else next ()

module Option = struct
  include Stdlib.Option

  let merge f a b =
    match (a, b) with
    | None, x | x, None -> x
    | Some x, Some y -> Some (f x y)

  let map2 f a b =
    match (a, b) with
    | Some x, Some y -> Some (f x y)
    | None, _ | _, None -> None
end
