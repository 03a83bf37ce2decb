let piece = 256

let init n f =
  if n <= piece then Array.init n f
  else
    let pieces = (n + piece - 1) / piece in
    let from k = Array.init (Int.min piece (n - (k * piece))) (fun i -> f ((k * piece) + i)) in
    Array.concat (List.init pieces from)

(* The first [left] of a list, the last of them first, and the rest. *)
let rec taken left found = function
  | x :: rest when left > 0 -> taken (left - 1) (x :: found) rest
  | rest -> (found, rest)

let of_list list =
  let rec pieces found list =
    match taken piece [] list with
    | [], _ -> List.rev found
    | some, rest -> pieces (Array.of_list (List.rev some) :: found) rest
  in
  if List.compare_length_with list piece <= 0 then Array.of_list list else Array.concat (pieces [] list)
