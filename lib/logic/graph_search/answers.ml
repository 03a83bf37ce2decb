open Bigarray

(* The answer for a state is a row of numbers:

   - how many lists of steps follow: 0 where its steps are not told; else all of them, after those that may do;
   - the version of the states ({!Shared_states.version}) by which edges were found plain;
   - the number of steps that have been left out, as they change nothing;
   - for each list a heading and its steps.

   A step is one number with its label, its flags and its target; or, where the target was not known, two: the
   second one is the key of the target. *)
type words = (int, int_elt, c_layout) Array1.t

let[@inline] word (words : words) at = Array1.unsafe_get words at

(* {2 Headings}: the number of steps, and two flags. *)

let flag_bits = 2
let labels_known = 1
let all_timed = 2
let[@inline] count heading = heading lsr flag_bits

(* {2 Steps} *)

let half = 31
let mask = (1 lsl half) - 1
let is_new = 1 lsl half

(* An edge to a known state that changes nothing; one to a new one of which there is nothing to tell. *)
let is_dull = is_new lsl 1

(* All that comes with a new one has come up before. *)
let has_entered = is_new lsl 2
let label_shift = half + 3
let most_label = 1 lsl (Sys.int_size - 2 - label_shift)
let[@inline] label step = step lsr label_shift
let[@inline] target step = step land mask
let[@inline] has flag step = step land flag <> 0

(* The next one of a list. *)
let[@inline] after words at = if has is_new (word words at) then at + 2 else at + 1
let rec end_of words at count = if count = 0 then at else end_of words (after words at) (count - 1)

let[@inline] version words at = word words (at + 1)
let[@inline] left_out words at = if word words at = 0 then 0 else word words (at + 2)

(* Of an answer: where the list of all steps begins, and that of some. *)
let first_list = 3
let second_list words at = end_of words (at + first_list + 1) (count (word words (at + first_list)))

exception Too_long
