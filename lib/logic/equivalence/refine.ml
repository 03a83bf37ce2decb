open Scc_data

type kind = Strong | Branching | Weak
type partition = { count : int; block : Int_array.t }

(* The states of a block stand side by side in [elements], those whose signature may have changed (the dirty
   ones) in front. The clean states of a block have one and the same signature. *)
type t = {
  g : Graph.t;
  back : Graph.backwards;
  effort : Effort.t;
  block : Int_array.t;
  elements : Int_array.t;
  place : Int_array.t;  (* of each state in [elements] *)
  begin_ : Int_array.buffer;  (* of each block *)
  end_ : Int_array.buffer;
  dirty : Int_array.buffer;  (* how many states of the block are dirty *)
  mutable waiting : Int_array.buffer;  (* blocks with dirty states, each once over both *)
  mutable later : Int_array.buffer;
  signatures : Signatures.t;
  signature : Int_array.t;  (* of each dirty state of the block at hand *)
  closure : Closure.t;
  pending : Int_array.buffer;
}

let block t s = Int_array.get t.block s

(* {1 Dirty states} *)

let is_dirty t s =
  let b = block t s in
  Int_array.get t.place s < Int_array.nth t.begin_ b + Int_array.nth t.dirty b

let move t s place =
  Int_array.set t.elements place s;
  Int_array.set t.place s place

let mark t s =
  let b = block t s in
  let n = Int_array.nth t.dirty b in
  let front = Int_array.nth t.begin_ b + n and place = Int_array.get t.place s in
  let other = Int_array.get t.elements front in
  move t other place;
  move t s front;
  if n = 0 then Int_array.push t.later b;
  Int_array.put t.dirty b (n + 1)

let mark_once t s = if not (is_dirty t s) then mark t s

(* Also the states whose signatures rest on that of [s], over inert steps. If [s] is dirty already then they
   are too: blocks only fall apart, so there are never more of them than when [s] was marked. *)
let mark_above t s =
  let visit s =
    if not (is_dirty t s) then begin
      mark t s;
      Int_array.push t.pending s
    end
  in
  visit s;
  while Int_array.size t.pending > 0 do
    let s = Int_array.pop t.pending in
    Effort.spend t.effort 1;
    Graph.sources t.back s (fun label source ->
        if Graph.is_tau label && block t source = block t s then visit source)
  done

(* {1 Signatures} *)

(* Labels and blocks are below 2^31. *)
let entry label block = (label lsl 31) lor block
let add t label block = Signatures.add t.signatures (entry label block)

let strong_signature t s =
  Signatures.start t.signatures;
  Graph.iter t.g s (fun label target -> add t label (block t target));
  Signatures.finish t.signatures

(* Inert successors are looked at before (states are taken in the order of their numbers), so their place in the
   partition to come is known: their signature's number, 0 for clean ones. A state either joins one of them, if it
   has nothing more to offer, or else sees all of them as blocks of their own. That one can only be the one of the
   greatest number: its signature has to name the others, and a signature names earlier ones alone. So signatures
   are never longer than the states' edges, and states are split only when they are not bisimilar: those without
   inert successors to their own class see the same classes, and the others join them. *)
let branching_signature t s =
  let own = block t s and greatest = ref (-1) in
  let class_ k = entry (Array.length t.g.labels) k in
  Signatures.start t.signatures;
  Graph.iter t.g s (fun label target ->
      if not (Graph.is_tau label && block t target = own) then add t label (block t target)
      else begin
        let k = if is_dirty t target then Int_array.get t.signature target else 0 in
        if k > !greatest then greatest := k;
        Signatures.add t.signatures (class_ k)
      end);
  if !greatest >= 0 && Signatures.within t.signatures ~except:(class_ !greatest) !greatest then !greatest
  else Signatures.finish t.signatures

let weak_signature t s =
  Signatures.start t.signatures;
  Closure.weak_steps t.closure s (fun label target -> add t label (block t target));
  Signatures.finish t.signatures

(* A clean state without inert successors: its own entries are the signature of all clean ones. *)
let rec bottom t s =
  let inert label target = Graph.is_tau label && block t target = block t s in
  let next = ref (-1) in
  if Graph.exists t.g s (fun l u -> inert l u && (next := u; true)) then bottom t !next else s

let dirty_states t b =
  let begin_ = Int_array.nth t.begin_ b in
  Array.init (Int_array.nth t.dirty b) (fun i -> Int_array.get t.elements (begin_ + i))

(* Signatures of the dirty states; number 0 is that of the clean ones if there are any. *)
let sign t kind b states =
  Signatures.clear t.signatures;
  let clean_place = Int_array.nth t.begin_ b + Array.length states in
  let clean = if clean_place < Int_array.nth t.end_ b then Some (Int_array.get t.elements clean_place) else None in
  let signature_of =
    match kind with
    | Strong ->
      Option.iter (fun c -> ignore (strong_signature t c)) clean;
      strong_signature t
    | Branching ->
      Array.stable_sort Int.compare states;
      Option.iter (fun c -> ignore (branching_signature t (bottom t c))) clean;
      branching_signature t
    | Weak ->
      Option.iter (fun c -> ignore (weak_signature t c)) clean;
      weak_signature t
  in
  Array.iter
    (fun s ->
       Effort.spend t.effort (1 + Int_array.get t.g.first (s + 1) - Int_array.get t.g.first s);
       Int_array.set t.signature s (signature_of s))
    states

(* {1 Splits} *)

(* Puts the dirty states in the order of their signatures, number 0 last, beside the clean states; gives the
   parts as (begin, end). *)
let arrange t b states =
  let begin_ = Int_array.nth t.begin_ b and end_ = Int_array.nth t.end_ b in
  let kinds = Signatures.count t.signatures in
  let sizes = Array.make kinds 0 in
  Array.iter (fun s -> let k = Int_array.get t.signature s in sizes.(k) <- sizes.(k) + 1) states;
  let next = Array.make kinds 0 in
  let stop = ref begin_ in
  let parts = ref [] in
  for k = 1 to kinds - 1 do
    next.(k) <- !stop;
    stop := !stop + sizes.(k);
    parts := (next.(k), !stop) :: !parts
  done;
  next.(0) <- !stop;
  Array.iter
    (fun s ->
       let k = Int_array.get t.signature s in
       move t s next.(k);
       next.(k) <- next.(k) + 1)
    states;
  (!stop, end_) :: !parts

let largest parts =
  List.fold_left (fun (b, e) (b', e') -> if e' - b' > e - b then (b', e') else (b, e)) (List.hd parts) parts

(* Gives the parts but the largest blocks of their own, and their (begin, end). *)
let split t b parts =
  let kept = largest parts in
  let moved = List.filter (fun part -> part <> kept) parts in
  Int_array.put t.begin_ b (fst kept);
  Int_array.put t.end_ b (snd kept);
  List.iter
    (fun (begin_, end_) ->
       let fresh = Int_array.size t.begin_ in
       Int_array.push t.begin_ begin_;
       Int_array.push t.end_ end_;
       Int_array.push t.dirty 0;
       for i = begin_ to end_ - 1 do
         Int_array.set t.block (Int_array.get t.elements i) fresh
       done)
    moved;
  moved

(* The states whose signatures speak of states that have moved. What has become visible of a state that has moved
   itself was in its signature already, as a class. Marking reorders a block, so they are listed
   first. *)
let touch t kind moved =
  let states =
    List.concat_map
      (fun (begin_, end_) -> List.init (end_ - begin_) (fun i -> Int_array.get t.elements (begin_ + i)))
      moved
  in
  match kind with
  | Strong -> List.iter (fun s -> Graph.sources t.back s (fun _ source -> mark_once t source)) states
  | Branching -> List.iter (fun s -> Graph.sources t.back s (fun _ source -> mark_above t source)) states
  | Weak -> Closure.weak_sources t.closure states (mark_once t)

let process t kind b =
  let states = dirty_states t b in
  sign t kind b states;
  Int_array.put t.dirty b 0;
  if Signatures.count t.signatures > 1 then touch t kind (split t b (arrange t b states))

let rec run t kind =
  if Int_array.size t.waiting > 0 then begin
    process t kind (Int_array.pop t.waiting);
    run t kind
  end
  else if Int_array.size t.later > 0 then begin
    let empty = t.waiting in
    t.waiting <- t.later;
    t.later <- empty;
    run t kind
  end

let coarsest effort kind (g : Graph.t) =
  let back = Graph.backwards g in
  let elements = Int_array.make g.size 0 and place = Int_array.make g.size 0 in
  for s = 0 to g.size - 1 do
    Int_array.set elements s s;
    Int_array.set place s s
  done;
  let one x =
    let b = Int_array.buffer () in
    Int_array.push b x;
    b
  in
  let t =
    {
      g;
      back;
      effort;
      block = Int_array.make g.size 0;
      elements;
      place;
      begin_ = one 0;
      end_ = one g.size;
      dirty = one g.size;
      waiting = one 0;
      later = Int_array.buffer ();
      signatures = Signatures.create ();
      signature = Int_array.make g.size 0;
      closure = Closure.make effort g back;
      pending = Int_array.buffer ();
    }
  in
  run t kind;
  { count = Int_array.size t.begin_; block = t.block }
