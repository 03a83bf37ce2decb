open Scc_base
open Scc_data
open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_property
open Scc_ctl
open Scc_evaluate
open Scc_engine

(* {1 Questions} *)

(* A number at a time needs the state then; all else, whatever comes on the way. *)
type question =
  | Value of Property.num * Rat.t
  | Formula of Path.question * Timed_formula.t

type questions = {
  semantics : Semantics.t;
  asked : question array;
  truths : (Trajectory.t -> Truth.t Timeline.t) array;  (** of each predicate of the formulas *)
  steady : bool array;
  counted : Property.prop option array;  (** by question: the transitions of which there is a number *)
  followed : bool;  (** something is asked on the way *)
  leaves : int list option;  (** the leaves that it depends on; [None]: all *)
  atoms : Atom.t list;  (** that it depends on *)
}

let value_at (p : Path.t) =
  match p.question with
  | Amounts (Value_at (n, time), _) -> Some (n, time)
  | Amounts ((Time_until _ | Events_until _), _) | Does -> None

(* An event is seen by the transition that led to a state. *)
let is_followed p =
  let is_event (a : Atom.t) = Option.is_some a.event in
  Option.is_none (value_at p) || List.exists is_event (Path.atoms p)

let questions semantics paths =
  let on_the_way = List.filter (fun p -> Option.is_none (value_at p)) paths in
  let formulas, props = Skeleton.of_temporal (List.map (fun (p : Path.t) -> p.formula) on_the_way) in
  let rigid = Option.is_some (Semantics.model semantics).Model.rigid in
  let formulas = ref formulas in
  let question (p : Path.t) =
    match (value_at p, !formulas) with
    | Some (n, time), _ -> Value (n, time)
    | None, formula :: rest ->
      formulas := rest;
      Formula (p.question, formula)
    | None, [] -> Bug.fail __POS__ "a formula for each question"
  in
  let counted (p : Path.t) =
    match p.question with
    | Amounts (Events_until (what, _), _) -> Some what
    | Amounts ((Time_until _ | Value_at _), _) | Does -> None
  in
  let followed = List.filter is_followed paths in
  {
    semantics;
    asked = Array.of_list (List.map question paths);
    truths = Array.map (Trajectory.predicate semantics) props;
    steady = Array.map (Formula.steady ~rigid) props;
    counted = Array.of_list (List.map counted paths);
    followed = followed <> [];
    leaves = Path.seen followed;
    atoms = List.concat_map Path.atoms followed;
  }

type answer = Truth of bool | Number of Rat.t | Never | Open | No_value of string

(* {1 Runs} *)

(* How a state is left: what is counted by a transition, for each question, or the truths while time passes. *)
type way =
  | Edge of (int * int) array
  | Flow of Rat.t * Truth.t Timeline.t array
  | Endless of Truth.t Timeline.t array
  | Ending
  | Unknown

type node = { at : Truth.t array; way : way }

type t = {
  q : questions;
  sums : Sums.t;
  answers : answer array;
  mutable nodes : node Growable.t;  (** the last ones *)
  mutable due : int;  (** how many of them make a look *)
  mutable decided : bool;  (** of these, all truths and numbers that a later answer depends on are known *)
  mutable length : int;  (** of the whole chain *)
  mutable since : Rat.t;  (** the time at the first of the nodes *)
  mutable now : Rat.t;  (** the time at the last of them *)
  earned : int array;  (** by question: what has been counted before the first of the nodes *)
  mutable present : State.t;  (** the last state, as far as it is followed *)
  mutable before : (State.t * Transition.label) option;  (** by which it was reached *)
  mutable within : State.t option;  (** the last state, if {!pass} added it *)
  mutable held : (int * answer) list;  (** answers to questions, once time has passed *)
  mutable over : bool;
}

let length t = t.length
let is_over t = t.over
let answers t = Array.to_list t.answers
let settled t = Array.for_all (fun a -> a <> Open) t.answers

(* The truths of so many states are kept until they are looked at. *)
let window = 8

let trajectory t state extent =
  let arrived event =
    match t.before with None -> false | Some (source, label) -> Event.matches ~source label event
  in
  Trajectory.make ~arrived ~total:(Sums.value t.sums) t.q.semantics state extent

let is_decided (truth : Truth.t) = match truth with True | False -> true | Undecided _ -> false

let note_decided t all = if not all then t.decided <- false

let now_in t =
  let trajectory = trajectory t t.present Timeline.Instant in
  Array.map (fun truth -> (truth trajectory).Timeline.start) t.q.truths

(* Of those that stay as they are nothing is asked while time passes. *)
let while_passing t extent =
  let trajectory = trajectory t t.present extent in
  let along k truth = if t.q.steady.(k) then Timeline.constant extent Truth.False else truth trajectory in
  let all = Array.mapi along t.q.truths in
  let decided (line : Truth.t Timeline.t) =
    is_decided line.start && is_decided line.first
    && List.for_all (fun (p : Truth.t Timeline.piece) -> is_decided p.at && is_decided p.after) line.rest
  in
  note_decided t (Array.for_all decided all);
  all

let last t = Growable.length t.nodes - 1
let leave t way = Growable.set t.nodes (last t) { (Growable.get t.nodes (last t)) with way }
let arrive t =
  let at = now_in t in
  note_decided t (Array.for_all is_decided at);
  Growable.push t.nodes { at; way = Unknown }

(* {1 Looks} *)

let graph t : Timed_graph.t =
  let way i = (Growable.get t.nodes i).way in
  {
    size = Growable.length t.nodes;
    known = (fun i -> match way i with Unknown -> false | Edge _ | Flow _ | Endless _ | Ending -> true);
    edges = (fun i -> match way i with Edge _ -> [| i + 1 |] | Flow _ | Endless _ | Ending | Unknown -> [||]);
    drawn = (fun _ -> None);
    flow =
      (fun i ->
         match way i with
         | Flow (d, _) -> Lasts (d, [| i + 1 |])
         | Endless _ -> Forever
         | Edge _ | Ending | Unknown -> No_flow);
  }

let predicates t : Eval.predicates =
  {
    at = (fun p i -> (Growable.get t.nodes i).at.(p));
    along =
      (fun p i _ ->
         match (Growable.get t.nodes i).way with
         | Flow (_, along) | Endless along -> along.(p)
         | Edge _ | Ending | Unknown -> Bug.fail __POS__ "a state in which no time passes");
    steady = (fun p -> t.q.steady.(p));
  }

let counts t k i =
  match (Growable.get t.nodes i).way with
  | Edge counts -> counts.(k)
  | Flow _ | Endless _ | Ending | Unknown -> (0, 0)

(* What is left of the bounds of time at the first of the nodes. *)
let left t (formula : Timed_formula.t) : Timed_formula.t =
  let bound ({ low; high } : Timed_formula.bound) : Timed_formula.bound =
    { low = Rat.max Rat.zero (Rat.sub low t.since); high = Option.map (fun h -> Rat.sub h t.since) high }
  in
  match formula with
  | Until (q, b, f, g) -> Until (q, bound b, f, g)
  | Finally (q, b, f) -> Finally (q, bound b, f)
  | Globally (q, b, f) -> Globally (q, bound b, f)
  | Predicate _ | Not _ | And _ | Or _ | Next _ -> formula

let truth eval formula : answer =
  match Eval.truth eval formula (Positions.start 0) with Some truth -> Truth truth | None -> Open

let all_time : Timed_formula.bound = { low = Rat.zero; high = None }

(* An answer, and whether a later one depends only on what comes after the nodes. Of what ends at no rational
   instant no number is known, and it is over. *)
let mean eval what goal ~earned =
  match Expectation.find eval Least what with
  | Known { least = Exact x; most = Exact y } when Rat.equal x y -> (Number (Rat.add earned x), true)
  | Known { least = Infinite; _ } -> (Never, true)
  | Unknown { reason = Some why; _ } -> (No_value why, true)
  | Known _ | Unknown { reason = None; _ } ->
    (Open, truth eval (Timed_formula.Finally (All, all_time, goal)) = Open)

let answer t eval k (question : Path.question) (formula : Timed_formula.t) =
  match (question, formula) with
  | Does, _ -> (truth eval (left t formula), true)
  | Amounts (Time_until _, _), Finally (_, _, goal) ->
    mean eval (Time_until goal) goal ~earned:t.since
  | Amounts (Events_until _, _), Until (_, _, _, goal) ->
    let count i _ = counts t k i in
    mean eval (Counts_until (count, goal)) goal ~earned:(Rat.of_int t.earned.(k))
  | Amounts ((Time_until _ | Events_until _ | Value_at _), _), _ -> Bug.fail __POS__ "a mean with another formula"

(* Only the last of the nodes is kept. *)
let forget t =
  let first = Growable.get t.nodes (last t) in
  for i = 0 to last t - 1 do
    Array.iteri (fun k earned -> t.earned.(k) <- earned + fst (counts t k i)) (Array.copy t.earned)
  done;
  t.nodes <- Growable.create ();
  Growable.push t.nodes first;
  t.since <- t.now;
  t.decided <- true;
  note_decided t (Array.for_all is_decided first.at)

let look t =
  let forgettable = ref (t.decided && not t.over) in
  let eval = lazy (Eval.create (Timed_graph.index (graph t)) (predicates t)) in
  let one k = function
    | Formula (question, formula) when t.answers.(k) = Open ->
      let found, later = answer t (Lazy.force eval) k question formula in
      t.answers.(k) <- found;
      if not later then forgettable := false
    | Formula _ | Value _ -> ()
  in
  Array.iteri one t.q.asked;
  if !forgettable then forget t;
  t.due <- (if !forgettable then window else Growable.length t.nodes * 3 / 2)

(* {1 Numbers at a time} *)

let of_number = function Ok x -> Number x | Error why -> No_value why

let values t ~lasts state =
  let extent : Timeline.extent = match lasts with Some d -> Lasts d | None -> Forever in
  let comes time =
    Rat.compare time t.now >= 0
    && match lasts with Some d -> Rat.compare time (Rat.add t.now d) < 0 | None -> true
  in
  let value k = function
    | Value (n, time) when t.answers.(k) = Open && comes time ->
      Some (k, of_number (Trajectory.number_at (trajectory t (state ()) extent) n (Rat.sub time t.now)))
    | Value _ | Formula _ -> None
  in
  List.filter_map Fun.id (Array.to_list (Array.mapi value t.q.asked))

let tell t = List.iter (fun (k, answer) -> t.answers.(k) <- answer)
let passing t ~lasts state = if not (settled t) then t.held <- values t ~lasts:(Some lasts) state

let at_the_end t state ~lasting =
  let state = match state with Some state -> state | None -> fun () -> Option.get t.within in
  let over k = function
    | Value (_, time) when t.answers.(k) = Open && Rat.compare time t.now > 0 ->
      t.answers.(k) <- No_value (Expectation.over_before ~elapsed:t.now time)
    | Value (n, _) when t.answers.(k) = Open ->
      t.answers.(k) <- of_number (Trajectory.number_at (trajectory t (state ()) Timeline.Instant) n Rat.zero)
    | Value _ | Formula _ -> ()
  in
  if lasting then tell t (values t ~lasts:None state) else Array.iteri over t.q.asked

(* {1 Steps} *)

let start q state =
  let of_leaves = Option.fold ~none:state ~some:(State.with_leaves state) q.leaves in
  let sums = Sums.make q.semantics q.atoms in
  Sums.count sums state;
  let t =
    {
      q; sums;
      answers = Array.map (fun _ -> Open) q.asked;
      nodes = Growable.create ();
      due = window;
      decided = true;
      length = 1;
      since = Rat.zero;
      now = Rat.zero;
      earned = Array.map (fun _ -> 0) q.asked;
      present = of_leaves;
      before = None;
      within = None;
      held = [];
      over = false;
    }
  in
  arrive t;
  t

let count t label =
  let one k what =
    match what with
    | Some what when t.answers.(k) = Open ->
      let { Counted.least; most } = Counted.by t.q.semantics ~source:t.present label what in
      note_decided t (least = most);
      (least, most)
    | Some _ | None -> (0, 0)
  in
  Array.mapi one t.q.counted

let follow t (label : Transition.label) sum state =
  leave t (match label with Time d -> Flow (d, while_passing t (Lasts d)) | _ -> Edge (count t label));
  sum ();
  t.before <- Some (t.present, label);
  t.present <- state ();
  arrive t;
  if Growable.length t.nodes >= t.due then look t

let move t label ~within sum state =
  t.length <- t.length + 1;
  if not (settled t) then begin
    if Transition.is_time label then tell t t.held;
    t.held <- [];
    t.within <- within;
    t.now <- Rat.add t.now (Transition.duration_of label);
    if t.q.followed then follow t label sum state
  end

let step t (taken : Run.alternative) ~state ~part =
  let sum () =
    match taken.replaced with
    | Some (gone, come) -> Sums.replace t.sums ~gone ~come
    | None -> if not (Sums.is_empty t.sums) then Sums.count t.sums (state ())
  in
  let state () = match t.q.leaves with Some leaves -> part leaves | None -> state () in
  move t taken.label ~within:None sum state

let pass t d s =
  let state () = Option.fold ~none:s ~some:(State.with_leaves s) t.q.leaves in
  move t (Time d) ~within:(Some s) ignore state

let for_ever t state =
  if not (settled t) then begin
    if t.q.followed then leave t (Endless (while_passing t Forever));
    at_the_end t state ~lasting:true
  end;
  t.over <- true

let dead_end t state =
  if not (settled t) then begin
    leave t Ending;
    at_the_end t state ~lasting:false
  end;
  t.over <- true
