open Scc_exact

let nothing = -1

(* The first slot from [i] on, of [width], that is not the same in both; or [width]. *)
let rec next_difference (a : int array) (b : int array) i width =
  if i = width || Array.unsafe_get a i <> Array.unsafe_get b i then i else next_difference a b (i + 1) width

(* [bodies], [values] and [total] are of the last tuple. They are not known while they are changed. *)
let of_tuples ~width ~zero ~exchange value =
  let bodies = Array.make width nothing and values = Array.make width zero in
  let total = ref zero and are_known = ref true in
  let forget () =
    Array.fill bodies 0 width nothing;
    Array.fill values 0 width zero;
    total := zero
  in
  let rec correct (tuple : int array) i =
    let i = next_difference tuple bodies i width in
    if i = width then Ok !total
    else
      match value tuple.(i) with
      | Error _ as e -> e
      | Ok v ->
        total := exchange !total values.(i) v;
        bodies.(i) <- tuple.(i);
        values.(i) <- v;
        correct tuple (i + 1)
  in
  fun tuple ->
    if not !are_known then forget ();
    are_known := false;
    let sum = correct tuple 0 in
    are_known := Result.is_ok sum;
    sum

let rationals ~width value =
  let exchange total before v = if Rat.equal v before then total else Rat.add total (Rat.sub v before) in
  of_tuples ~width ~zero:Rat.zero ~exchange value

let integers ~width value = of_tuples ~width ~zero:0 ~exchange:(fun total before v -> total - before + v) value
