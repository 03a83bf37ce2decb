open Scc_base
open Scc_exact
open Scc_broad_phase
open Scc_semantics

type t = { local : Local.t; contacts : Contact_cache.t }

let create ~memory local = { local; contacts = Contact_cache.create ~most:memory }

(* Two that are not in contact before the time of this rank. *)
type open_pair = { bound : int; one : Local.alone; two : Local.alone }

type found = {
  mutable collisions : Local.move list;
  mutable rank : int;  (** of the least time that is known *)
  mutable time : Rat.t;
  mutable still_open : open_pair list;  (** those that may be earlier *)
}

let none = max_int

let collisions found = found.collisions
let number (a : Local.alone) (b : Local.alone) = (a.body.number lsl 31) lor b.body.number

(* Not before this time, by boxes; infinite, if never. *)
let not_before (a : Local.alone) (b : Local.alone) =
  let one = Later.force a.line and two = Later.force b.line in
  let hulls = Moving_boxes.not_inside_before one 0 two 0 in
  let n = Moving_boxes.count one and m = Moving_boxes.count two in
  if hulls > 0. || (n = 2 && m = 2) then hulls
  else begin
    let least = ref infinity in
    for i = 1 to n - 1 do
      for j = 1 to m - 1 do
        least := Float.min !least (Moving_boxes.not_inside_before one i two j)
      done
    done;
    !least
  end

let look_at_pair t pair a b =
  let bound = not_before a b in
  if bound = infinity then Contact_cache.keep_never t.contacts pair
  else if bound = 0. && Local.collisions t.local a b <> [] then Contact_cache.keep_meeting t.contacts pair
  else Contact_cache.keep_not_before t.contacts pair bound

let earlier found rank time =
  if rank < found.rank || (rank = found.rank && Rat.compare time found.time < 0) then begin
    found.rank <- rank;
    found.time <- time
  end

let rec consider t found (a : Local.alone) (b : Local.alone) pair code =
  if code = Contact_cache.meeting then
    found.collisions <- List.rev_append (Local.collisions t.local a b) found.collisions
  else if code = Contact_cache.unknown then begin
    look_at_pair t pair a b;
    consider t found a b pair (Contact_cache.find t.contacts pair)
  end
  else if code <> Contact_cache.never then begin
    let rank = Contact_cache.rank code in
    if Contact_cache.is_exact code then begin
      if rank <= found.rank then earlier found rank (Contact_cache.time t.contacts pair)
    end
    else if rank <= found.rank then found.still_open <- { bound = rank; one = a; two = b } :: found.still_open
  end

let in_relative_motion (processes : Local.alone array) =
  let velocity i = (Array.unsafe_get processes i).Local.body.velocity in
  let rec from i = i > 0 && (velocity i <> velocity 0 || from (i - 1)) in
  from (Array.length processes - 1)

let among t (processes : Local.alone array) =
  let found = { collisions = []; rank = none; time = Rat.zero; still_open = [] } in
  let k = if in_relative_motion processes then Array.length processes else 0 in
  for i = 0 to k - 2 do
    let a = Array.unsafe_get processes i in
    for j = i + 1 to k - 1 do
      let b = Array.unsafe_get processes j in
      if a.body.velocity <> b.body.velocity then begin
        let pair = number a b in
        let code = Contact_cache.find t.contacts pair in
        if code <> Contact_cache.never then consider t found a b pair code
      end
    done
  done;
  found

let resolve t found { one; two; _ } =
  let processes = [| one.body.process; two.body.process |] and pair = number one two in
  match Collisions.first_time_of_contact (Local.afresh t.local) processes ~limit:None with
  | None -> Contact_cache.keep_never t.contacts pair
  | Some time ->
    Contact_cache.keep_time t.contacts pair time;
    earlier found (Contact_cache.rank_of time) time

(* Those that may be the first are looked at exactly, the most likely one first, until one is the first. *)
let rec first_contact t found =
  match List.filter (fun p -> p.bound <= found.rank) found.still_open with
  | [] -> if found.rank = none then None else Some found.time
  | first :: rest ->
    let likely = List.fold_left (fun best p -> if p.bound < best.bound then p else best) first rest in
    found.still_open <- List.filter (fun p -> p != likely) (first :: rest);
    resolve t found likely;
    first_contact t found
