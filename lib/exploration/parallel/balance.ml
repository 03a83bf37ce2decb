(* Seconds of work that a request is to be worth. A longer one would hold back states that follow: what leads to them
   is looked for by others meanwhile, and is found to be new several times. *)
let request_seconds = 500e-6
let most_states = 512

(* Seconds that a state is to take, for others to be of use. *)
let worth = 0.3e-6

(* A mean of fewer says little; what is older than so many counts half. *)
let enough = 100
let many = 1 lsl 15

(* Of states that take little time, one of so many is timed for all: to ask a clock takes a twentieth of a
   microsecond. *)
let one_of = 16

type mean = { mutable seconds : float; mutable count : int }

type t = { now : unit -> float; find : mean; mutable states : int  (** of a request *) }

let create ~now = { now; find = { seconds = 0.; count = 0 }; states = 8 }
let each m = m.seconds /. float_of_int m.count

let count_one m =
  m.count <- m.count + 1;
  if m.count > many then begin
    m.count <- m.count / 2;
    m.seconds <- m.seconds /. 2.
  end

(* Clocks may be set back. *)
let timed b m ~times work =
  let start = b.now () in
  let result = work () in
  m.seconds <- m.seconds +. (float_of_int times *. Float.max 0. (b.now () -. start));
  result

let finding b work =
  let times = if b.find.count < enough || each b.find > 20e-6 then 1 else one_of in
  let result = if b.find.count land (times - 1) = 0 then timed b b.find ~times work else work () in
  count_one b.find;
  result

let pays b = b.find.seconds > worth *. float_of_int b.find.count

let answered b ~states ~worked =
  if states > 0 then begin
    let seconds = Float.max 1e-7 (worked /. float_of_int states) in
    b.states <- Int.max 1 (Int.min most_states (int_of_float (request_seconds /. seconds)))
  end

(* Near the end of a level requests are small, so that all processes end at about the same time. *)
let request b ~waiting ~jobs = Int.max 1 (Int.min b.states (waiting / (2 * jobs)))
