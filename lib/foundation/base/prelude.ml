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

  let all f list =
    let add found x = map2 (fun found y -> y :: found) found (f x) in
    map List.rev (List.fold_left add (Some []) list)
end

module Result = struct
  include Stdlib.Result

  let all f list =
    let rec go found = function
      | [] -> Ok (List.rev found)
      | x :: rest -> ( match f x with Ok y -> go (y :: found) rest | Error e -> Error e)
    in
    go [] list

  let listed r = map_error (fun e -> [ e ]) r
end
