open Scc_exact

let nothing = -1

(* The first slot from [i] on, of [width], that is not the same in both; or [width]. *)
let rec next_difference (a : int array) (b : int array) i width =
  if i = width || Array.unsafe_get a i <> Array.unsafe_get b i then i
  else next_difference a b (i + 1) width

(* [bodies] are those of the last tuple, of which [put] has been told. They are not known while they change. *)
let of_tuples ~width ~forget ~put total =
  let bodies = Array.make width nothing and are_known = ref true in
  let rec correct (tuple : int array) i =
    let i = next_difference tuple bodies i width in
    if i = width then Ok (total ())
    else
      match put i tuple.(i) with
      | Error why -> Error why
      | Ok () ->
        bodies.(i) <- tuple.(i);
        correct tuple (i + 1)
  in
  fun tuple ->
    if not !are_known then begin
      Array.fill bodies 0 width nothing;
      forget ()
    end;
    are_known := false;
    let sum = correct tuple 0 in
    are_known := Result.is_ok sum;
    sum

let rationals ~width value =
  let values = Array.make width Rat.zero and total = ref Rat.zero in
  let forget () =
    Array.fill values 0 width Rat.zero;
    total := Rat.zero
  in
  let put i body =
    match value body with
    | Error why -> Error why
    | Ok v ->
      let before = values.(i) in
      if not (v == before || Rat.equal v before) then total := Rat.add !total (Rat.sub v before);
      values.(i) <- v;
      Ok ()
  in
  of_tuples ~width ~forget ~put (fun () -> !total)

let integers ~width value =
  let values : int array = Array.make width 0 and total = ref 0 in
  let forget () =
    Array.fill values 0 width 0;
    total := 0
  in
  let put i body =
    match value body with
    | Error why -> Error why
    | Ok v ->
      total := !total - values.(i) + v;
      values.(i) <- v;
      Ok ()
  in
  of_tuples ~width ~forget ~put (fun () -> !total)
