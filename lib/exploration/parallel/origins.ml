(* By the last bits of the number of the state. *)
type t = { states : int array; workers : int array; answers : int array; steps : int array }

let size = 1 lsl 15
let create () =
  let none () = Array.make size (-1) in
  { states = none (); workers = none (); answers = none (); steps = none () }

let put t state ~worker ~answer ~step =
  let k = state land (size - 1) in
  t.states.(k) <- state;
  t.workers.(k) <- worker;
  t.answers.(k) <- answer;
  t.steps.(k) <- step

let find t state ~worker =
  let k = state land (size - 1) in
  if t.states.(k) = state && t.workers.(k) = worker then Some (t.answers.(k), t.steps.(k)) else None
