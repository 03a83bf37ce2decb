open Scc_exact
open Scc_data

type asked = All | States of int list

type found =
  | By_graph
  | In_rationals
  | In_intervals of { sweeps : int; not_exact : Exact_solver.given_up option }
  | Given_up of Exact_solver.given_up

type t = { value : int -> Answer.t; scheduler : int array Lazy.t; found : found }

let value t s = t.value s
let scheduler t = Lazy.force t.scheduler
let found t = t.found

(* Values and rows of the nodes. *)
type nodes = { of_node : int -> Answer.t; row : int -> int; how : found }

let exactly (s : Exact_solver.solution) =
  { of_node = (fun v -> Answer.Exact s.value.(v)); row = Array.get s.row; how = In_rationals }

let nearly e effort ~possible ~rewards ~asked =
  let upper = if rewards then infinity else 1. in
  let s = Interval_solver.solve e effort ~upper ~asked in
  let of_node v : Answer.t =
    match s.interval v with
    | low, None -> if Rat.sign low = 0 then possible else At_least low
    | low, Some high -> if Rat.equal low high then Exact low else Within (low, high)
  in
  { of_node; row = Array.get s.row; how = In_intervals { sweeps = s.sweeps; not_exact = None } }

(* Below this size of all components exact values take no longer than intervals. *)
let small = 1_000

let has_large_part (e : Equations.t) =
  let rec from k = k < Array.length e.parts - 1 && (e.parts.(k + 1) - e.parts.(k) > small || from (k + 1)) in
  from 0

let decided n bound asked = Array.for_all (fun v -> Option.is_some (Answer.holds (n.of_node v) bound)) asked

(* Of a large part it cannot be told beforehand whether exact values or intervals decide a bound sooner. Both are
   tried in turn, with more and more effort, before exact values get all of it: so many products of small numbers
   for these, and so many looks at the clock for intervals. *)
let turns = [ (1 lsl 22, 16); (1 lsl 26, 512) ]

(* That is over after so many looks at the clock, which depend on nothing but the work. *)
let looking (effort : Effort.t) looks =
  let left = ref looks in
  let interrupted () =
    decr left;
    !left < 0 || effort.interrupted ()
  in
  { effort with interrupted }

let nodes (e : Equations.t) (effort : Effort.t) ~possible ~rewards ~asked =
  let nearly effort = nearly e effort ~possible ~rewards ~asked in
  if e.size = 0 then { of_node = (fun _ -> possible); row = (fun _ -> 0); how = By_graph }
  else
    match effort.engine with
    | Nearly -> nearly effort
    | Exactly -> (
        match Exact_solver.solve e effort with
        | Ok s -> exactly s
        | Error why ->
          { of_node = (fun _ -> possible); row = (fun v -> Equations.first_row e v); how = Given_up why })
    | Either -> (
        let exactly_or_nearly () =
          let given_up = ref None in
          let not_exact why =
            given_up := Some why;
            effort.not_exact why
          in
          let exactly effort = Result.map exactly (Exact_solver.solve e effort) in
          let enough n = Option.fold ~none:false ~some:(fun bound -> decided n bound asked) effort.bound in
          let found = Exact_first.run { effort with not_exact } ~exactly ~nearly ~enough in
          match found.how with
          | In_intervals { sweeps; _ } -> { found with how = In_intervals { sweeps; not_exact = !given_up } }
          | By_graph | In_rationals | Given_up _ -> found
        in
        match effort.bound with
        | Some bound when has_large_part e ->
          let rec turn = function
            | [] -> exactly_or_nearly ()
            | (steps, looks) :: rest -> (
                match Exact_solver.solve e { effort with steps = Int.min steps effort.steps } with
                | Ok s -> exactly s
                | Error (Interrupted | Too_long | Too_much) ->
                  let found = nearly (looking effort looks) in
                  if decided found bound asked then found else turn rest)
          in
          turn turns
        | Some _ | None -> exactly_or_nearly ())

(* In a merged component the state that has the chosen choice is gone to, by internal choices. *)
let spread back (e : Equations.t) (merged : Components.ends) row (choice : int array) =
  let found = Worklist.create (Mdp.states (Backwards.mdp back)) in
  for v = 0 to e.size - 1 do
    let c = Equations.choice e (row v) in
    let s = Backwards.owner back c in
    choice.(s) <- c;
    Worklist.add found s
  done;
  Worklist.run found (fun t ->
      if merged.number.(t) >= 0 then
        Backwards.iter back t (fun c ->
            let s = Backwards.owner back c in
            if Bits.mem merged.internal c && not (Worklist.mem found s) then begin
              choice.(s) <- c;
              Worklist.add found s
            end))

type problem = {
  direction : Equations.direction;
  status : int -> Equations.status;
  elsewhere : Answer.t;
  allowed : int -> bool;
  merged : Components.ends;
  rewards : bool;
  choice : int -> int;
}

let equations back { direction; status; allowed; merged; rewards; _ } ~asked =
  Equations.make back direction ~status ~allowed ~merged ~rewards ~asked

let solve back effort ~asked problem =
  let { status; elsewhere; merged; rewards; choice; _ } = problem in
  let m = Backwards.mdp back in
  let n = Mdp.states m in
  let possible : Answer.t = if rewards then At_least Rat.zero else Within (Rat.zero, Rat.one) in
  let is_asked =
    match asked with
    | All -> None
    | States l ->
      let set = Bits.create n in
      List.iter (Bits.add set) l;
      Some (Bits.mem set)
  in
  let e = equations back problem ~asked:is_asked in
  let asked =
    match asked with
    | All -> Array.init e.size Fun.id
    | States l ->
      let nodes = List.filter (fun v -> v >= 0) (List.map (Equations.node_of e) l) in
      Array.of_list (List.sort_uniq Int.compare nodes)
  in
  let nodes = nodes e effort ~possible ~rewards ~asked in
  let value s : Answer.t =
    match status s with
    | Known x -> Exact x
    | Elsewhere -> elsewhere
    | Open -> if (Equations.node_of e s) < 0 then possible else nodes.of_node (Equations.node_of e s)
  in
  let scheduler =
    lazy
      (let chosen = Array.init n choice in
       spread back e merged nodes.row chosen;
       Array.mapi (fun s c -> if c < 0 then 0 else c - Mdp.first_choice m s) chosen)
  in
  { value; scheduler; found = nodes.how }
