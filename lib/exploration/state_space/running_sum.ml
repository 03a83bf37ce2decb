open Scc_exact

(* What the slots of the last tuple hold, and what that is worth. Neither is known while they change. *)
type 'value last = { bodies : int array; values : 'value array; mutable total : 'value; mutable are_known : bool }

let nothing = -1

let last ~width zero =
  { bodies = Array.make width nothing; values = Array.make width zero; total = zero; are_known = true }

let begin_with last zero =
  if not last.are_known then begin
    Array.fill last.bodies 0 (Array.length last.bodies) nothing;
    Array.fill last.values 0 (Array.length last.values) zero;
    last.total <- zero
  end;
  last.are_known <- false

(* The first slot from [i] on, of [width], that is not the same in both; or [width]. *)
let next_difference (a : int array) (b : int array) i width =
  let i = ref i in
  while !i < width && Array.unsafe_get a !i = Array.unsafe_get b !i do
    incr i
  done;
  !i

let rationals ~width value =
  let last = last ~width Rat.zero in
  let rec correct (tuple : int array) i total =
    let i = next_difference tuple last.bodies i width in
    if i = width then Ok total
    else
      let body = Array.unsafe_get tuple i in
      match value body with
      | Error _ as why -> why
      | Ok v ->
        let before = Array.unsafe_get last.values i in
        last.bodies.(i) <- body;
        if v == before || Rat.equal v before then correct tuple (i + 1) total
        else begin
          last.values.(i) <- v;
          correct tuple (i + 1) (Rat.add total (Rat.sub v before))
        end
  in
  fun tuple ->
    begin_with last Rat.zero;
    match correct tuple 0 last.total with
    | Error _ as why -> why
    | Ok total as sum ->
      last.total <- total;
      last.are_known <- true;
      sum

(* On its own, as an array of any values would be looked at for what it holds each time. *)
let integers ~width value =
  let last : int last = last ~width 0 in
  let rec correct (tuple : int array) i total =
    let i = next_difference tuple last.bodies i width in
    if i = width then total
    else begin
      let body = Array.unsafe_get tuple i in
      let v = value body in
      let before = Array.unsafe_get last.values i in
      last.bodies.(i) <- body;
      last.values.(i) <- v;
      correct tuple (i + 1) (total - before + v)
    end
  in
  fun tuple ->
    begin_with last 0;
    let total = correct tuple 0 last.total in
    last.total <- total;
    last.are_known <- true;
    total
