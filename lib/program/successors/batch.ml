open Scc_base
open Scc_graph_search

(* The transitions of a state, and how many came before them in the answer. *)
type group = { before : int; source : int array; steps : Lts.step list }

(* Of transitions; cleared for each answer. *)
type columns = {
  states : Columns.states;
  prints : Buffer.t;
  labels : Buffer.t;
  print : Keys.fingerprint;  (** to work with *)
  mutable groups : group list;  (** the last first *)
  mutable moves : int;
}

type t = {
  mutable filter : Filter.t;
  mutable told : int;  (** so many labels are known on the other side *)
  columns : columns;
  mutable last : group array;  (** of the last answer *)
  news : News.t;
}

let columns () =
  let b () = Buffer.create 65536 in
  {
    states = Columns.states ();
    prints = b (); labels = b ();
    print = Keys.no_fingerprint ();
    groups = []; moves = 0;
  }

let clear c =
  Columns.clear c.states;
  List.iter Buffer.clear [ c.prints; c.labels ];
  c.groups <- [];
  c.moves <- 0

let make filter = { filter; told = 0; columns = columns (); last = [||]; news = News.make () }
let most = 1 lsl 30
let lost = Frame.lost

(* {1 Targets} *)

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
  let places = Frame.numbers frame in
  if String.length frame <> Frame.bytes_from places then lost "there is more than it says";
  let c = Columns.targets () in
  let keys = Filter.keys t.filter in
  let put index place =
    let tuple = target_of t place in
    Columns.put_target t.filter c index tuple (Keys.fingerprint keys tuple)
  in
  Array.iteri put places;
  let text = Told.of_targets (List.rev c.doubts) in
  Frame.put out
    [ Array.length places; Buffer.length c.bytes; String.length text ]
    [ c.flags; c.goals; c.lengths; c.bytes ]
    text

(* {1 Transitions} *)

let put_moves t c _ source steps =
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
    Frame.put_number c.labels (Filter.label_number t.filter s.label);
    for i = 0 to (Array.length changes / 2) - 1 do
      let slot = changes.(2 * i) in
      target.(slot) <- source.(slot)
    done
  in
  List.iter put steps;
  if steps <> [] then c.groups <- { before = c.moves; source; steps } :: c.groups;
  c.moves <- c.moves + List.length steps

(* Labels that have not been told yet, and the notes. *)
let text t c =
  let known = Filter.labels t.filter in
  let model = (Filter.question t.filter).loaded.model in
  let labels = List.init (known - t.told) (fun i -> Filter.label t.filter (t.told + i)) in
  t.told <- known;
  Told.of_moves model labels (List.rev c.states.notes)

let expand t frame ~with_targets out =
  let lengths = Frame.numbers frame in
  let c = t.columns in
  clear c;
  Columns.read t.filter c.states frame ~from:(Frame.bytes_from lengths) lengths (put_moves t c);
  t.last <- Array.of_list (List.rev c.groups);
  c.groups <- [];
  let text = text t c in
  Frame.put out
    [ Array.length lengths; c.moves; String.length text ]
    [ c.states.follows; c.states.counts; c.states.ahead; c.prints; c.labels ]
    text;
  if with_targets then begin
    let places = Buffer.create 4096 in
    Frame.put_number places 3;
    Frame.put_number places c.moves;
    Frame.put_numbers places (Array.init c.moves Fun.id);
    recall t (Buffer.contents places) out
  end

(* Tuples of the last answer mean nothing to another filter. *)
let renew t =
  let filter = Filter.renew t.filter in
  if filter != t.filter then begin
    t.filter <- filter;
    clear t.columns;
    t.last <- [||]
  end

let answer t frame out =
  let request () =
    match Frame.number frame 0 with
    | 1 -> renew t; expand t frame ~with_targets:true out
    | 2 -> renew t; expand t frame ~with_targets:false out
    | 3 -> recall t frame out
    | 4 -> renew t; News.expand t.news t.filter frame out
    | 5 -> News.meet t.news frame out
    | 6 -> News.keep t.news frame out
    | kind -> lost "there is no request %d" kind
  in
  match request () with
  | () -> Ok ()
  | exception Frame.Lost what ->
    Error (Diag.error Code.lost_frame Span.none "this is no batch of states: %s" what)
