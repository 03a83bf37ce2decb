open Scc_exact

let nothing = -1

(* [bodies], [values] and [total] are of the last tuple. They are not known while they are changed. *)
let of_tuples ~width value =
  let bodies = Array.make width nothing and values = Array.make width Rat.zero in
  let total = ref Rat.zero and are_known = ref true in
  let forget () =
    Array.fill bodies 0 width nothing;
    Array.fill values 0 width Rat.zero;
    total := Rat.zero
  in
  let rec correct (tuple : int array) i =
    if i = width then Ok !total
    else if tuple.(i) = bodies.(i) then correct tuple (i + 1)
    else
      match value tuple.(i) with
      | Error _ as e -> e
      | Ok v ->
        let before = values.(i) in
        bodies.(i) <- tuple.(i);
        values.(i) <- v;
        if not (Rat.equal v before) then total := Rat.add !total (Rat.sub v before);
        correct tuple (i + 1)
  in
  fun tuple ->
    if not !are_known then forget ();
    are_known := false;
    let sum = correct tuple 0 in
    are_known := Result.is_ok sum;
    sum
