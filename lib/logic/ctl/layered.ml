open Scc_data
open Scc_exact
open Scc_chance
open Decisions
open Layers

(* {1 Backwards} *)

exception Interrupted

(* What is computed of each place of a layer: its value, and the number of steps to the goal by choices that attain
   it, which is [never] if there are none. The arrays have an element for each place of the layer, or for each rank
   where that is not many more. *)
type 'a computed = { value : 'a array; steps : int array; by_rank : bool }

let never = max_int

type 'a backwards = {
  numbers : 'a Arithmetic.t;
  ends : 'a array;  (** the value of each end, by its number *)
  computed : 'a computed array;  (** of each layer; empty where it is not needed any more *)
  taken : Int_array.t array;
  (** Of each place the branch with the fewest steps to the goal, counted through all its choices. It is empty if
      no run is wanted. *)
}

let slot computed layer rank = if computed.by_rank then rank else index layer rank

let find b layer rank get ~goal ~fail =
  if rank = at_goal then goal
  else if rank = at_fail then fail
  else
    let computed = b.computed.(number layer) in
    (get computed).(slot computed layer rank)

let value_of b layer rank =
  if rank < at_fail then b.ends.(end_number rank)
  else find b layer rank (fun c -> c.value) ~goal:b.numbers.one ~fail:b.numbers.zero

let best_of (side : Timed_formula.side) compare a b =
  match side with Least -> if compare b a < 0 then b else a | Greatest -> if compare b a > 0 then b else a

(* The fewest steps by one of the choices with the best value, and the first branch that begins so. *)
let shortest t b layer choices values best =
  let least = ref never and taken = ref 0 and k = ref 0 in
  Array.iteri
    (fun c { target; delay; _ } ->
       let attains = b.numbers.compare values.(c) best = 0 in
       Array.iteri
         (fun i s ->
            if attains then begin
              let next = later t layer delay.(i) in
              let rest = find b next (rank_of t s) (fun c -> c.steps) ~goal:0 ~fail:never in
              if rest < !least then begin
                least := rest;
                taken := !k
              end
            end;
            incr k)
         target)
    choices;
  ((if !least = never then never else !least + 1), !taken)

let compute_place t b ~trace layer i =
  let rank = Int_array.get (ranks layer) i in
  let s = node_of t rank in
  let choices = choices_of t layer s in
  let value { weights; target; delay } =
    b.numbers.mean weights (fun k ->
        let next = if delay.(k) = 0 then layer else later t layer delay.(k) in
        value_of b next (rank_of t target.(k)))
  in
  let values = Array.map value choices in
  let best = Array.fold_left (best_of (side t) b.numbers.compare) values.(0) values in
  let computed = b.computed.(number layer) in
  let slot = if computed.by_rank then rank else i in
  computed.value.(slot) <- best;
  if trace then begin
    let steps, taken = shortest t b layer choices values best in
    computed.steps.(slot) <- steps;
    Int_array.set b.taken.(number layer) i taken
  end

(* From the last layer back. [keep] is called once a layer is computed. *)
let backwards t (effort : Effort.t) ?(ends = [||]) numbers ~trace keep =
  let layers = all t and all_ranks = count t in
  let size = Array.length layers in
  let none = { value = [||]; steps = [||]; by_rank = false } in
  let b = { numbers; ends; computed = Array.make size none; taken = Array.make size (Int_array.make 0 0) } in
  let over = Array.make size [] in
  Array.iter (fun layer -> over.(first_source layer) <- number layer :: over.(first_source layer)) layers;
  for k = size - 1 downto 0 do
    if effort.interrupted () then raise Interrupted;
    let layer = layers.(k) in
    let n = Int_array.length (ranks layer) in
    let by_rank = n > all_ranks / 8 in
    let slots = if by_rank then all_ranks else n in
    b.computed.(k) <-
      { value = Array.make slots numbers.zero; steps = (if trace then Array.make slots never else [||]); by_rank };
    if trace then b.taken.(k) <- Int_array.make n 0;
    for i = 0 to n - 1 do
      compute_place t b ~trace layer i
    done;
    keep b layer;
    List.iter (fun l -> b.computed.(l) <- none) over.(k)
  done;
  b

(* {1 Values of the starts} *)

type values = Answer.t Places.t

let value values = function
  | Goal -> Answer.Exact Rat.one
  | Fail -> Exact Rat.zero
  | Go p -> Places.find values p

let by_time t =
  let table = Hashtbl.create 16 in
  let add = function
    | Goal | Fail | Go { elapsed = None; _ } -> ()
    | Go ({ elapsed = Some time; _ } as p) ->
      Hashtbl.add table (number (layer_of t time)) p
  in
  List.iter add (starts t);
  table

let rationals t effort ~ends numbers =
  let starts = by_time t and found = Places.create 16 in
  let keep b layer =
    let note (p : place) =
      Places.replace found p (numbers.Arithmetic.to_rat (value_of b layer (rank_of t p.node)))
    in
    List.iter note (Hashtbl.find_all starts (number layer))
  in
  ignore (backwards t effort ~ends numbers ~trace:false keep);
  found

let map f table =
  let result = Places.create (Places.length table) in
  Places.iter (fun p x -> Places.replace result p (f p x)) table;
  result

(* What is computed is [scaled]: integers from 0 to [most] at ends, which stand for their rewards. *)
type scale = { scaled : Z.t array; most : Rat.t; back : Rat.t -> Rat.t }

let scale t =
  let rewards = rewards t in
  if Array.length rewards = 0 then { scaled = [||]; most = Rat.one; back = Fun.id }
  else
    let least = Array.fold_left Rat.min rewards.(0) rewards in
    let unit = Array.fold_left (fun d x -> Z.lcm d (Rat.sub x least).den) Z.one rewards in
    let unit = Rat.make unit Z.one in
    let scaled = Array.map (fun x -> (Rat.mul unit (Rat.sub x least)).num) rewards in
    let most = Rat.make (Array.fold_left Z.max Z.zero scaled) Z.one in
    { scaled; most; back = (fun x -> Rat.add least (Rat.div x unit)) }

let unknown t =
  let found = Places.create 16 and { most; back; _ } = scale t in
  let nothing = Answer.Within (back Rat.zero, back most) in
  List.iter (function Go p -> Places.replace found p nothing | Goal | Fail -> ()) (starts t);
  found

let values t effort numbers =
  let { scaled; back; _ } = scale t in
  let ends = Array.map numbers.Arithmetic.integer scaled in
  map (fun _ x -> back x) (rationals t effort ~ends numbers)

let enclosed t effort =
  let low = values t effort (Arithmetic.rounded Down) in
  let high = values t effort (Arithmetic.rounded Up) in
  map
    (fun p low ->
       let high = Places.find high p in
       if Rat.equal low high then Answer.Exact low else Within (low, high))
    low

(* Powers of a long base would be longer than the numbers themselves. *)
let longest_base = 64

(* Numbers of all layers may be as long as those of the first one. *)
let longest = 20_000

type 'r user = { use : 'a. 'a Arithmetic.t -> 'r }

let exactly t (effort : Effort.t) { use } =
  let bits = Int.min longest effort.bits in
  if Z.numbits (base t) <= longest_base then use (Arithmetic.exact ~base:(base t) ~bits)
  else use (Arithmetic.rational ~bits)

let solve t (effort : Effort.t) =
  let exact effort =
    match exactly t effort { use = (fun numbers -> values t effort numbers) } with
    | found -> Ok (map (fun _ x -> Answer.Exact x) found)
    | exception Interrupted -> Error Lifting.Interrupted
    | exception Arithmetic.Too_long -> Error Too_long
  in
  let nearly effort = try enclosed t effort with Interrupted -> unknown t in
  match effort.engine with
  | Nearly -> nearly effort
  | Exactly -> Result.value (exact effort) ~default:(unknown t)
  | Either -> Exact_first.run effort ~exactly:exact ~nearly ~enough:(Fun.const false)

(* {1 Runs} *)

let rec nth_branch choices k =
  match choices with
  | [] -> Scc_base.Bug.fail __POS__ "a branch that a place does not have"
  | branches :: rest ->
    let n = List.length branches in
    if k < n then List.nth branches k else nth_branch rest (k - n)

let follow t taken start =
  let rec go next trail =
    match next with
    | Goal -> List.rev trail
    | Fail | Go { elapsed = None; _ } -> Scc_base.Bug.fail __POS__ "a run to the goal does not come there"
    | Go ({ elapsed = Some time; node } as p) ->
      let layer = layer_of t time in
      let k = Int_array.get taken.(number layer) (index layer (rank_of t node)) in
      let branch = nth_branch (choices t p) k in
      go branch.next ((p, branch) :: trail)
  in
  go start []

let traced t effort start numbers =
  let arrives = ref (match start with Goal -> true | Fail | Go _ -> false) in
  let keep b layer =
    match start with
    | Go { node; elapsed = Some at } when Rat.equal at (time layer) ->
      arrives := find b layer (rank_of t node) (fun c -> c.steps) ~goal:0 ~fail:never < never
    | Goal | Fail | Go _ -> ()
  in
  let b = backwards t effort numbers ~trace:true keep in
  if !arrives then Some (follow t b.taken start) else None

let run t (effort : Effort.t) start =
  let exact () = exactly t effort { use = (fun numbers -> traced t effort start numbers) } in
  let near () =
    traced t effort start (Arithmetic.rounded (match side t with Least -> Up | Greatest -> Down))
  in
  try
    match effort.engine with
    | _ when not (is_free t) -> traced t effort start Arithmetic.nothing
    | Nearly -> near ()
    | Exactly -> exact ()
    | Either -> ( try exact () with Arithmetic.Too_long -> near ())
  with Interrupted | Arithmetic.Too_long -> None
