open Scc_base
open Scc_ctl
open Scc_explore
open Scc_exchange

(* The transitions of a state, and how many came before them in the answer. *)
type group = { before : int; source : int array; steps : Lts.step list }

(* Of transitions; cleared for each answer. *)
type columns = {
  follows : Buffer.t;
  counts : Buffer.t;
  ahead : Buffer.t;
  prints : Buffer.t;
  labels : Buffer.t;
  print : Keys.fingerprint;  (** to work with *)
  mutable groups : group list;  (** the last first *)
  mutable moves : int;
  mutable notes : Json.t list;  (** what numbers do not tell, the last first *)
}

type t = {
  mutable filter : Filter.t;
  mutable told : int;  (** so many labels are known on the other side *)
  columns : columns;
  mutable last : group array;  (** of the last answer *)
}

let columns () =
  let b () = Buffer.create 65536 in
  {
    follows = b (); counts = b (); ahead = b (); prints = b (); labels = b ();
    print = Keys.no_fingerprint ();
    groups = []; moves = 0; notes = [];
  }

let in_order c = [ c.follows; c.counts; c.ahead; c.prints; c.labels ]

let clear c =
  List.iter Buffer.clear (in_order c);
  c.groups <- [];
  c.moves <- 0;
  c.notes <- []

let make filter = { filter; told = 0; columns = columns (); last = [||] }
let most = 1 lsl 30

(* {1 Reading} *)

exception Lost of string

let lost fmt = Printf.ksprintf (fun text -> raise (Lost text)) fmt

let number frame at =
  if at + 4 > String.length frame then lost "it ends too early";
  Int32.to_int (String.get_int32_le frame at) land 0xFFFF_FFFF

(* The numbers that follow the kind and how many they are. *)
let numbers frame =
  let n = number frame 4 in
  if n > (String.length frame - 8) / 4 then lost "it is shorter than it says";
  Array.init n (fun i -> number frame (8 + (4 * i)))

(* {1 Writing} *)

let put_number b n = Buffer.add_int32_le b (Int32.of_int n)
let put_numbers b = Array.iter (put_number b)

let put_frame out head columns text =
  let size = List.fold_left (fun n b -> n + Buffer.length b) 0 columns in
  put_number out ((4 * List.length head) + size + String.length text);
  List.iter (put_number out) head;
  List.iter (Buffer.add_buffer out) columns;
  Buffer.add_string out text

let notes_text members notes =
  let members = if notes = [] then members else members @ [ ("notes", `List (List.rev notes)) ] in
  if members = [] then "" else Json.line (`Assoc members)

let note index (members : (string * Json.t) list) notes =
  if members = [] then notes else (`Assoc (("index", `Int index) :: members) : Json.t) :: notes

let texts values told : Json.t = `List (Array.to_list (Array.map told values))

(* {1 Targets} *)

type targets = {
  flags : Buffer.t;
  goals : Buffer.t;
  lengths : Buffer.t;
  bytes : Buffer.t;
  mutable doubts : Json.t list;
}

let targets () =
  let b () = Buffer.create 4096 in
  { flags = b (); goals = b (); lengths = b (); bytes = b (); doubts = [] }

let truth : Truth.t -> int = function False -> 0 | True -> 1 | Undecided _ -> 2
let undecided : Truth.t -> bool = function Undecided _ -> true | True | False -> false

let put_target t c index tuple =
  let r = Filter.reached t.filter tuple in
  Buffer.add_uint8 c.flags (if r.too_long then 1 else 0);
  Array.iter (fun g -> Buffer.add_uint8 c.goals (truth g)) r.goals;
  let before = Buffer.length c.bytes in
  Keys.put (Filter.keys t.filter) c.bytes tuple;
  put_number c.lengths (Buffer.length c.bytes - before);
  if Array.exists undecided r.goals then c.doubts <- note index [ ("goals", texts r.goals Told.truth) ] c.doubts

(* Where the transition of a place of the last answer leads. *)
let target_of t place =
  let rec group low high =
    (* It is in one of these, the second excluded. *)
    if high - low = 1 then t.last.(low)
    else
      let middle = (low + high) / 2 in
      if t.last.(middle).before <= place then group middle high else group low middle
  in
  let total = t.columns.moves in
  if place >= total then lost "transition %d is not there, of %d" place total;
  let g = group 0 (Array.length t.last) in
  Tuples.apply (List.nth g.steps (place - g.before)).changes g.source

let recall t frame out =
  let places = numbers frame in
  if String.length frame <> 8 + (4 * Array.length places) then lost "there is more than it says";
  let c = targets () in
  Array.iteri (fun index place -> put_target t c index (target_of t place)) places;
  let text = notes_text [] c.doubts in
  put_frame out
    [ Array.length places; Buffer.length c.bytes; String.length text ]
    [ c.flags; c.goals; c.lengths; c.bytes ]
    text

(* {1 Transitions} *)

let is_no_state = 5

let follows : _ Filter.following -> int = function
  | Moves _ -> 0
  | Rests -> 1
  | Ends _ -> 2
  | Stops -> 3
  | Fault _ -> 4

let ahead : Filter.ahead option -> int = function
  | None -> 0
  | Some { met; doubt } -> (if Option.is_some met then 1 else 0) lor if Option.is_some doubt then 2 else 0

let put_moves t c source steps =
  let keys = Filter.keys t.filter in
  let before = Keys.fingerprint keys source in
  let target = Array.copy source in
  let put (s : Lts.step) =
    let changes = s.changes in
    for i = 0 to (Array.length changes / 2) - 1 do
      target.(changes.(2 * i)) <- changes.((2 * i) + 1)
    done;
    Keys.move keys ~into:c.print before source changes target;
    Keys.put_fingerprint c.prints c.print;
    put_number c.labels (Filter.label_number t.filter s.label);
    for i = 0 to (Array.length changes / 2) - 1 do
      let slot = changes.(2 * i) in
      target.(slot) <- source.(slot)
    done
  in
  List.iter put steps;
  if steps <> [] then c.groups <- { before = c.moves; source; steps } :: c.groups;
  c.moves <- c.moves + List.length steps

let put_state t c index source ((bare : Filter.bare), look_ahead) =
  Buffer.add_uint8 c.follows (follows bare);
  Array.iter (fun a -> Buffer.add_uint8 c.ahead (ahead a)) look_ahead;
  let steps = match bare with Moves steps -> steps | Rests | Ends _ | Stops | Fault _ -> [] in
  put_number c.counts (List.length steps);
  put_moves t c source steps;
  let of_ahead =
    if Array.for_all (fun a -> ahead a = 0) look_ahead then []
    else [ ("ahead", texts look_ahead (Json.option Told.ahead)) ]
  in
  let reason =
    match bare with Ends d | Fault d -> [ ("reason", Told.diagnostic d) ] | Moves _ | Rests | Stops -> []
  in
  c.notes <- note index (of_ahead @ reason) c.notes

let put_no_state t c index d =
  Buffer.add_uint8 c.follows is_no_state;
  put_number c.counts 0;
  Array.iter (fun _ -> Buffer.add_uint8 c.ahead 0) (Filter.question t.filter).goals;
  c.notes <- note index [ ("error", Told.diagnostic d) ] c.notes

(* Labels that have not been told yet, and the notes. *)
let text t c =
  let known = Filter.labels t.filter in
  let model = (Filter.question t.filter).loaded.model in
  let label i : Json.t = `Assoc (Told.label model (Filter.label t.filter (t.told + i))) in
  let labels = List.init (known - t.told) label in
  t.told <- known;
  notes_text (if labels = [] then [] else [ ("labels", `List labels) ]) c.notes

let expand t frame ~with_targets out =
  let lengths = numbers frame in
  let begins = 8 + (4 * Array.length lengths) in
  if Array.fold_left ( + ) begins lengths <> String.length frame then lost "its states are not as long as it says";
  t.filter <- Filter.renew t.filter;
  let c = t.columns in
  clear c;
  let from = ref begins in
  let state index length =
    let stop = !from + length in
    (match Filter.read t.filter frame ~from:!from ~stop with
     | Error d -> put_no_state t c index d
     | Ok source -> (
         match Filter.look t.filter source with
         | Ok found -> put_state t c index source found
         | Error d -> put_no_state t c index d));
    from := stop
  in
  Array.iteri state lengths;
  t.last <- Array.of_list (List.rev c.groups);
  c.groups <- [];
  let text = text t c in
  put_frame out
    [ Array.length lengths; c.moves; String.length text ]
    (in_order c) text;
  if with_targets then begin
    let places = Buffer.create 4096 in
    put_number places 3;
    put_number places c.moves;
    put_numbers places (Array.init c.moves Fun.id);
    recall t (Buffer.contents places) out
  end

let answer t frame out =
  let request () =
    match number frame 0 with
    | 1 -> expand t frame ~with_targets:true out
    | 2 -> expand t frame ~with_targets:false out
    | 3 -> recall t frame out
    | kind -> lost "there is no request %d" kind
  in
  match request () with
  | () -> Ok ()
  | exception Lost what -> Error (Diag.error Code.lost_frame Span.none "this is no batch of states: %s" what)
