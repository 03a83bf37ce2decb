open Scc_system
open Scc_successors

type place = { number : int; count : int }

(* {1 The parent} *)

type parent = {
  text : Buffer.t;
  mutable ended : bool;
  mutable waited_for : bool;  (** it has not said that what was kept is safe *)
}

let chunk = Bytes.create 4096

let hear parent () =
  match Reading.input chunk 0 (Bytes.length chunk) with
  | 0 -> parent.ended <- true
  | n ->
    parent.waited_for <- false;
    Buffer.add_subbytes parent.text chunk 0 n

let most_line = 1 lsl 22

let rec first_line parent =
  let text = Buffer.contents parent.text in
  match String.index_opt text '\n' with
  | Some at -> Some (String.sub text 0 at)
  | None when parent.ended -> None
  | None ->
    if String.length text > most_line then Failure.refused "the first line of the input is too long";
    hear parent ();
    first_line parent

let say line =
  Standard.print (line ^ "\n");
  Standard.flush ()

(* {1 The work} *)

(* The bytes of the table of what has been sent. *)
let sent_bytes = 1 lsl 28

let searches (q : Question.t) =
  let is_search (_, (plan : Question.plan)) = match plan with Other -> false | _ -> true in
  q.plans <> [] && List.for_all is_search q.plans

let most_levels =
  match Scc_verify.Bounds.default.instant with Unbounded -> None | Default n | Given n -> Some n

(* At most so often is anything told that is not kept. *)
let often = 0.3

type t = {
  place : place;
  begun : Said.begin_;
  part : Part.t;
  levels : Levels.t;
  records : Records.t array;  (** by owner *)
  home : int;  (** the owner of the initial state *)
  parent : parent;
  mutable trace : Trace.t option;
  mutable cycles : Cycles.t option;
  mutable free : Free.t option;  (** if it goes in no order *)
  wanted : Wanted.t option;  (** what is to be evaluated *)
  mutable gathering : Gathering.t option;
  mutable shown : float;  (** when it told last how far it is *)
  mutable saved : int;  (** levels *)
  mutable telling : bool;  (** everything is found *)
}

(* The parent ends the input once the first owner has told. *)
exception Over

let hear_parent o () =
  hear o.parent ();
  Buffer.clear o.parent.text;
  if o.parent.ended then
    if o.telling then raise Over else Failure.lost "the process that has started this owner has ended"

let show o (p : Progress.t) =
  let now = Unix.gettimeofday () in
  if o.place.number = 0 && now -. o.shown > often then begin
    o.shown <- now;
    say (Said.line (Going p))
  end

let keep o (p : Progress.t) =
  match o.begun.folder with
  | None -> ()
  | Some folder ->
    let file = Filename.concat folder (Printf.sprintf "%d-%d.levels" o.place.number p.level) in
    Shard.write file o.part o.levels p ~from:o.saved;
    say (Said.line (Kept { level = p.level; from = o.saved; file; progress = p }));
    o.parent.waited_for <- true;
    o.saved <- Levels.count o.levels

let hear_peer o peer kind text =
  if Char.equal kind Expansion.state then begin
    Records.read o.records.(peer) o.part ~sender:peer text ignore;
    Option.iter Free.hear_states o.free
  end
  else
    let known =
      match (o.trace, o.cycles) with
      | _, Some cycles when Char.equal kind Cycles.kind ->
        Cycles.heard cycles peer text;
        true
      | Some trace, _ when Char.equal kind Trace.kind || Char.equal kind Trace.told ->
        Trace.heard trace kind text;
        true
      | _ ->
        let heard by = Option.fold ~none:false ~some:(fun x -> by x peer kind text) in
        heard Gathering.heard o.gathering || heard Free.heard o.free
    in
    if not known then Failure.refused "owner %d sends a message of no kind: %C" (peer + 1) kind

let hear_peer o peer kind text =
  try hear_peer o peer kind text
  with Scc_codec.Packed.Malformed what -> Failure.refused "owner %d: %s" (peer + 1) what

(* How far it came before. *)
let restored o =
  let read _ file = Some (Shard.read file o.part o.levels) in
  let progress = List.fold_left read None o.begun.restore in
  o.saved <- Levels.count o.levels;
  let goal_found (p : Progress.t) =
    Array.iteri (fun goal place -> if Option.is_some place then Part.found o.part goal) p.met
  in
  Option.iter goal_found progress;
  progress

let most_states o = Option.value o.begun.states ~default:max_int

(* {1 What is more than searches} *)

(* The graph of all owners, where formulas are to be evaluated. *)
let gathered o numbers ~is_expanded =
  match o.gathering with
  | None -> None
  | Some gathering ->
    Option.map (fun graph -> (gathering, graph)) (Gathering.gather gathering (numbers ()) ~is_expanded)

(* At the first owner, while others wait for its questions. *)
let formulas (wanted : Wanted.t) mesh gathering graph =
  let listened = ref 0. in
  let listen () =
    let now = Unix.gettimeofday () in
    if now -. !listened > often then begin
      listened := now;
      Mesh.pump mesh 0.
    end;
    None
  in
  let surroundings = Scc_graph_search.Limits.undivided ~stop:listen () in
  Scc_state_space.Formulas.on ~surroundings wanted.formulas
    {
      graph = Gathered.graph graph;
      predicates = Gathered.predicates graph;
      number = Gathering.value gathering graph;
      counted = (fun p -> Gathered.counted graph (Wanted.pattern wanted p));
    }

(* Whether more states matter: all owners hear from the first one. *)
let are_settled o mesh numbers (graph : Cycles.graph) =
  match o.wanted with
  | None -> false
  | Some wanted ->
    let is_settled (gathering, graph) = Conclusion.are_settled wanted (formulas wanted mesh gathering graph) in
    let found = gathered o numbers ~is_expanded:graph.is_expanded in
    Mesh.sums mesh [ Bool.to_int (Option.fold ~none:false ~some:is_settled found) ] = [ 1 ]

(* {1 The exploration} *)

let in_step o mesh expansion =
  let settings : In_step.settings =
    {
      searches = searches (Filter.question (Part.filter o.part));
      most_states = most_states o;
      most_at_once = most_levels;
      every = Option.map (fun ms -> float_of_int ms /. 1000.) o.begun.every;
    }
  in
  let numbers () = Node_numbers.by_levels mesh o.levels in
  let calls : In_step.calls =
    {
      keep = keep o;
      may_keep = (fun () -> not o.parent.waited_for);
      show = show o;
      settled = are_settled o mesh numbers;
    }
  in
  let s = In_step.make o.part mesh expansion o.levels settings calls in
  let p = In_step.run s (match restored o with Some p -> p | None -> In_step.begin_ s ~home:o.home) in
  (p, In_step.graph s, numbers)

let by_time o mesh expansion clock =
  let question = Filter.question (Part.filter o.part) in
  let settings : By_time.settings =
    {
      searches = searches question;
      within = Array.map (fun (g : Question.goal) -> g.within) question.goals;
      horizon = Question.horizon question;
      most_states = most_states o;
      most_rounds = most_levels;
    }
  in
  let numbers s () = Node_numbers.by_turns mesh o.part clock ~turns:(By_time.turns s) in
  let settled s = are_settled o mesh (numbers s) (By_time.graph s) in
  let s = By_time.make o.part clock mesh expansion settings ~show:(show o) ~settled in
  let p = By_time.run s ~home:o.home in
  (p, By_time.graph s, numbers s)

let in_any_order o mesh expansion =
  let searches = searches (Filter.question (Part.filter o.part)) in
  let free = Free.make o.part mesh expansion ~searches ~most_states:(most_states o) ~show:(show o) in
  o.free <- Some free;
  (free, Free.run free ~home:o.home)

(* What was found, a cycle, and the graph. *)
let found_by o mesh cycles expansion =
  let in_order (p, (graph : Cycles.graph), numbers) =
    let cycle = Cycles.find cycles graph in
    (p, cycle, gathered o numbers ~is_expanded:graph.is_expanded)
  in
  match (o.begun.order, Part.clock o.part) with
  | Any, _ ->
    let free, p = in_any_order o mesh expansion in
    if Option.is_some o.gathering then begin
      (* What was found when it ended may not have been sent. *)
      ignore (Expansion.flush expansion);
      ignore (Mesh.gather mesh (fun _ -> ""))
    end;
    let numbers () = Node_numbers.as_they_come mesh o.part ~home:o.home in
    (* Without an order, nothing tells which transitions lead back. *)
    (p, None, gathered o numbers ~is_expanded:(Free.is_expanded free))
  | _, Some clock -> in_order (by_time o mesh expansion clock)
  | (Levels | Time), None -> in_order (in_step o mesh expansion)

let explore o mesh cycles =
  let expansion = Expansion.make o.part mesh o.records ~sent:(Sent.create ~bytes:sent_bytes) in
  let p, cycle, graph = found_by o mesh cycles expansion in
  o.telling <- true;
  if o.place.number > 0 then Mesh.let_go mesh;
  match Mesh.sums mesh [ Mesh.messages mesh; Mesh.bytes mesh ] with
  | [ messages; bytes ] -> (p, cycle, graph, messages, bytes)
  | _ -> (p, cycle, graph, 0, 0)

let conclusions o mesh progress = function
  | None -> []
  | Some (gathering, graph) ->
    let wanted = Option.get o.wanted in
    Conclusion.all wanted (formulas wanted mesh gathering graph) progress ~most_states:(most_states o)

(* The first owner tells what was found; others answer it until the end of the input. *)
let tell o mesh trace (p, cycle, graph, messages, bytes) =
  let goals = Array.length p.Progress.met in
  let runs = Trace.all trace (Array.append p.met [| Option.map fst cycle |]) in
  let conclusions = conclusions o mesh p graph in
  Mesh.let_go mesh;
  let lasso (_, round) =
    let stem = Option.value (List.assoc_opt goals runs) ~default:[] in
    { Said.choices = stem @ round; from = List.length stem }
  in
  let runs = List.filter (fun (goal, _) -> goal < goals) runs in
  let found = { Said.progress = p; runs; cycle = Option.map lasso cycle; conclusions; messages; bytes } in
  if o.place.number = 0 then say (Said.line (Found found));
  while true do Mesh.pump mesh (-1.) done

let work o self ~listener =
  let seconds = float_of_int o.begun.deadline /. 1000. in
  let links = Meeting.meet self ~listener ~peers:o.begun.peers ~seconds in
  let mesh = Mesh.make ~number:o.place.number ~links ~each:(hear_peer o) ~from_parent:(hear_parent o) in
  let find ~level before =
    match (o.begun.order, Part.clock o.part) with
    | Any, _ -> Some before
    | _, Some clock -> Clock.find clock before
    | (Levels | Time), None -> Levels.find o.levels level before
  in
  let trace = Trace.make mesh o.part ~find ~is_root:(fun id -> id = 0 && o.home = o.place.number) in
  o.trace <- Some trace;
  let cycles = Cycles.make o.part mesh o.records in
  o.cycles <- Some cycles;
  o.gathering <- Option.map (Gathering.make o.part mesh o.records) o.wanted;
  try tell o mesh trace (explore o mesh cycles) with Over -> ()

let run filter place ~listener ~program ~identity =
  let parent = { text = Buffer.create 4096; ended = false; waited_for = false } in
  match first_line parent with
  | None -> ()
  | Some line ->
    let begun = Said.read_begin ~count:place.count line in
    let states = Option.fold ~none:"" ~some:string_of_int begun.states in
    let evaluates = if begun.evaluate then [ "evaluate" ] else [] in
    let identity =
      String.concat "\n" ([ identity; begun.run; states; Said.order_name begun.order ] @ evaluates)
    in
    let self : Greeting.self =
      { number = place.number; count = place.count; program; secret = begun.secret; identity }
    in
    let spill folder mib = Scc_data.Spill.to_folder folder ~beyond:(mib lsl 20) in
    ignore (Option.map2 spill begun.folder begun.memory);
    let clock = match begun.order with Time -> Some (Clock.make ()) | Levels | Any -> None in
    let part = Part.make ?clock filter in
    let wanted = if begun.evaluate then Some (Wanted.find filter) else None in
    let o =
      {
        place; begun; part; parent;
        wanted = Option.bind wanted (fun w -> if w.checks = [] then None else Some w);
        levels = Levels.make ();
        records = Array.init place.count (fun _ -> Records.make part);
        home = (Filter.initial filter).fingerprint.(0) mod place.count;
        trace = None; cycles = None; free = None; gathering = None; shown = 0.; saved = 0; telling = false;
      }
    in
    work o self ~listener
