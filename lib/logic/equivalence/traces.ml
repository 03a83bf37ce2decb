open Scc_exact

type view = Every_action | Observable
type step = Action of int | Time of Rat.t

type outcome =
  | Trace of { steps : step list; first : bool }
  | Same
  | Too_large
  | Unclear

type limits = { pairs : int; members : int }

let to_decide = { pairs = 400_000; members = 40_000_000 }
let to_explain = { pairs = 100_000; members = 2_000_000 }

(* Where a trace can lead to. *)
type set = {
  number : int;
  members : int list;  (* ascending *)
  exact : bool;  (* no trace to here went through an unknown state, and no member is unknown *)
}

type t = {
  effort : Effort.t;
  limits : limits;
  mutable members_seen : int;
  view : view;
  m : System.t;
  sets : (string, set) Hashtbl.t;
  pairs : (int * int, unit) Hashtbl.t;
  queue : (set * set * step list) Queue.t;  (* with the trace, the last step first *)
  mutable unclear : bool;
}

exception Found of outcome

(* Of every set that is made, whether it is new or not: the work there is in it. *)
let count t n =
  t.members_seen <- t.members_seen + n;
  if t.members_seen > t.limits.members then raise (Found Too_large);
  Effort.spend t.effort (1 + n)

let set t ~exact positions =
  let members =
    List.sort_uniq Int.compare
      (match t.view with Every_action -> positions | Observable -> System.silent_closure t.m positions)
  in
  count t (List.length members);
  let exact = exact && List.for_all (System.known t.m) members in
  let key = String.concat "," (string_of_bool exact :: List.map string_of_int members) in
  match Hashtbl.find_opt t.sets key with
  | Some s -> s
  | None ->
    let s = { number = Hashtbl.length t.sets; members; exact } in
    Hashtbl.add t.sets key s;
    s

let is_empty s = match s.members with [] -> true | _ :: _ -> false

let visit t one two trace =
  let key = (one.number, two.number) in
  if one.number <> two.number && not (Hashtbl.mem t.pairs key) then begin
    if Hashtbl.length t.pairs >= t.limits.pairs then raise (Found Too_large);
    Hashtbl.add t.pairs key ();
    Queue.add (one, two, trace) t.queue
  end

(* After a step of both: a difference, nothing, or a pair to look at. *)
let arrive t one two step trace =
  let trace = step :: trace in
  let found first = raise (Found (Trace { steps = List.rev trace; first })) in
  match (is_empty one, is_empty two) with
  | true, true -> ()
  | false, true -> if two.exact then found true else t.unclear <- true
  | true, false -> if one.exact then found false else t.unclear <- true
  | false, false -> visit t one two trace

module Actions = Map.Make (Int)

let by_action t s =
  let add map p =
    let map = ref map in
    System.actions t.m p (fun a target ->
        if not (t.view = Observable && Graph.is_tau a) then
          map := Actions.update a (fun l -> Some (target :: Option.value ~default:[] l)) !map);
    !map
  in
  List.fold_left add Actions.empty s.members

let patience t s =
  List.fold_left (fun least p -> System.shorter least (System.patience t.m p)) System.Never s.members

let expand t (one, two, trace) =
  if not (one.exact && two.exact) then t.unclear <- true;
  let first = by_action t one and second = by_action t two in
  let step a l1 l2 =
    let reached from l = set t ~exact:from.exact (Option.value ~default:[] l) in
    arrive t (reached one l1) (reached two l2) (Action a) trace;
    None
  in
  ignore (Actions.merge step first second);
  match System.common (patience t one) (patience t two) with
  | None -> ()
  | Some d ->
    let reached from = set t ~exact:from.exact (List.concat_map (fun p -> System.wait t.m p d) from.members) in
    arrive t (reached one) (reached two) (Time d) trace

let rec search t =
  if Queue.is_empty t.queue then if t.unclear then Unclear else Same
  else begin
    expand t (Queue.pop t.queue);
    search t
  end

let compare effort limits view m p q =
  let t =
    {
      effort;
      limits;
      members_seen = 0;
      view;
      m;
      sets = Hashtbl.create 1024;
      pairs = Hashtbl.create 1024;
      queue = Queue.create ();
      unclear = false;
    }
  in
  match
    visit t (set t ~exact:true [ p ]) (set t ~exact:true [ q ]) [];
    search t
  with
  | outcome -> outcome
  | exception Found outcome -> outcome

let possible view ~sure m p steps =
  let seen set = match view with Every_action -> set | Observable -> System.silent_closure m set in
  let after set = function
    | Action a -> List.concat_map (fun p -> System.after m p a) set
    | Time d -> List.concat_map (fun p -> System.wait m p d) set
  in
  let is_known = System.known m in
  let rec follow set = function
    | [] -> true
    | step :: rest ->
      ((not sure) && not (List.for_all is_known set))
      ||
      let next = seen (List.sort_uniq Int.compare (after set step)) in
      (match next with [] -> false | _ :: _ -> follow next rest)
  in
  follow (seen [ p ]) steps

(* Durations in a row are one. *)
let formula store view steps =
  let step s f =
    match (s, view) with
    | Time d, _ -> Modal_formula.can store (Modal_formula.Wait d) f
    | Action a, Every_action -> Modal_formula.can store (Modal_formula.Now a) f
    | Action a, Observable -> Modal_formula.can store (Modal_formula.Weakly a) f
  in
  if List.compare_length_with steps Game.most_parts > 0 then None
  else Some (List.fold_left (fun f s -> step s f) (Modal_formula.yes store) (List.rev steps))
