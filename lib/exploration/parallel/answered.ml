open Bigarray
open Scc_graph_search

type numbers = (int32, int32_elt, c_layout) Array1.t

(* The numbers of the tuple, and then of each step how many its changes have, and these; all are less than 2^31.
   16 MiB, in which a system puts nothing before it is written. *)
type t = { width : int; ring : numbers; mutable place : int  (** of the next number *) }

let size = 1 lsl 22
let surely = size / 2
let create ~width = { width; ring = Array1.create int32 c_layout size; place = 0 }
let[@inline] at (ring : numbers) place = Int32.to_int (Array1.unsafe_get ring (place land (size - 1)))

let[@inline] set (ring : numbers) place number =
  Array1.unsafe_set ring (place land (size - 1)) (Int32.of_int number)

let put t (numbers : int array) =
  let ring = t.ring and place = t.place in
  for i = 0 to Array.length numbers - 1 do
    set ring (place + i) (Array.unsafe_get numbers i)
  done;
  t.place <- place + Array.length numbers

let put_step t (s : Lts.step) =
  set t.ring t.place (Array.length s.changes);
  t.place <- t.place + 1;
  put t s.changes

let keep t tuple steps =
  put t tuple;
  List.iter (put_step t) steps

let tuple t ~answer ~step =
  if answer < 0 || step < answer || step >= t.place || t.place - answer > size then None
  else begin
    let tuple = Array.make t.width 0 and ring = t.ring in
    for i = 0 to t.width - 1 do
      Array.unsafe_set tuple i (at ring (answer + i))
    done;
    for k = 0 to (at ring step / 2) - 1 do
      tuple.(at ring (step + (2 * k) + 1)) <- at ring (step + (2 * k) + 2)
    done;
    Some tuple
  end

let words t = Int.min t.place size / (Sys.word_size / 32)
let room_of_step (s : Lts.step) = 1 + Array.length s.changes
let first_step ~width = width
let room ~width steps = List.fold_left (fun n s -> n + room_of_step s) width steps
