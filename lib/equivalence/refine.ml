type kind = Strong | Branching | Weak
type partition = { count : int; block : Ints.t }

(* The states of a block stand side by side in [elements], those whose signature may have changed (the dirty
   ones) in front. The clean states of a block have one and the same signature. *)
type t = {
  g : Graph.t;
  back : Graph.backwards;
  effort : Effort.t;
  block : Ints.t;
  elements : Ints.t;
  place : Ints.t;  (* of each state in [elements] *)
  begin_ : Ints.buffer;  (* of each block *)
  end_ : Ints.buffer;
  dirty : Ints.buffer;  (* how many states of the block are dirty *)
  mutable waiting : Ints.buffer;  (* blocks with dirty states, each once over both *)
  mutable later : Ints.buffer;
  signatures : Signatures.t;
  signature : Ints.t;  (* of each dirty state of the block at hand *)
  closure : Closure.t;
  pending : Ints.buffer;
}

let block t s = Ints.get t.block s

(* {1 Dirty states} *)

let is_dirty t s =
  let b = block t s in
  Ints.get t.place s < Ints.nth t.begin_ b + Ints.nth t.dirty b

let move t s place =
  Ints.set t.elements place s;
  Ints.set t.place s place

let mark t s =
  let b = block t s in
  let n = Ints.nth t.dirty b in
  let front = Ints.nth t.begin_ b + n and place = Ints.get t.place s in
  let other = Ints.get t.elements front in
  move t other place;
  move t s front;
  if n = 0 then Ints.push t.later b;
  Ints.put t.dirty b (n + 1)

let mark_once t s = if not (is_dirty t s) then mark t s

(* Also the states whose signatures rest on that of [s], over inert steps. If [s] is dirty already then they
   are too: blocks only fall apart, so there are never more of them than when [s] was marked. *)
let mark_above t s =
  let visit s =
    if not (is_dirty t s) then begin
      mark t s;
      Ints.push t.pending s
    end
  in
  visit s;
  while Ints.size t.pending > 0 do
    let s = Ints.pop t.pending in
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
        let k = if is_dirty t target then Ints.get t.signature target else 0 in
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
  let begin_ = Ints.nth t.begin_ b in
  Array.init (Ints.nth t.dirty b) (fun i -> Ints.get t.elements (begin_ + i))

(* Signatures of the dirty states; number 0 is that of the clean ones if there are any. *)
let sign t kind b states =
  Signatures.clear t.signatures;
  let clean_place = Ints.nth t.begin_ b + Array.length states in
  let clean = if clean_place < Ints.nth t.end_ b then Some (Ints.get t.elements clean_place) else None in
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
       Effort.spend t.effort (1 + Ints.get t.g.first (s + 1) - Ints.get t.g.first s);
       Ints.set t.signature s (signature_of s))
    states

(* {1 Splits} *)

(* Puts the dirty states in the order of their signatures, number 0 last, beside the clean states; gives the
   parts as (begin, end). *)
let arrange t b states =
  let begin_ = Ints.nth t.begin_ b and end_ = Ints.nth t.end_ b in
  let kinds = Signatures.count t.signatures in
  let sizes = Array.make kinds 0 in
  Array.iter (fun s -> let k = Ints.get t.signature s in sizes.(k) <- sizes.(k) + 1) states;
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
       let k = Ints.get t.signature s in
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
  Ints.put t.begin_ b (fst kept);
  Ints.put t.end_ b (snd kept);
  List.iter
    (fun (begin_, end_) ->
       let fresh = Ints.size t.begin_ in
       Ints.push t.begin_ begin_;
       Ints.push t.end_ end_;
       Ints.push t.dirty 0;
       for i = begin_ to end_ - 1 do
         Ints.set t.block (Ints.get t.elements i) fresh
       done)
    moved;
  moved

(* The states whose signatures speak of states that have moved. What has become visible of a state that has moved
   itself was in its signature already, as a class. Marking reorders a block, so they are listed
   first. *)
let touch t kind moved =
  let states =
    List.concat_map
      (fun (begin_, end_) -> List.init (end_ - begin_) (fun i -> Ints.get t.elements (begin_ + i)))
      moved
  in
  match kind with
  | Strong -> List.iter (fun s -> Graph.sources t.back s (fun _ source -> mark_once t source)) states
  | Branching -> List.iter (fun s -> Graph.sources t.back s (fun _ source -> mark_above t source)) states
  | Weak -> Closure.weak_sources t.closure states (mark_once t)

let process t kind b =
  let states = dirty_states t b in
  sign t kind b states;
  Ints.put t.dirty b 0;
  if Signatures.count t.signatures > 1 then touch t kind (split t b (arrange t b states))

let rec run t kind =
  if Ints.size t.waiting > 0 then begin
    process t kind (Ints.pop t.waiting);
    run t kind
  end
  else if Ints.size t.later > 0 then begin
    let empty = t.waiting in
    t.waiting <- t.later;
    t.later <- empty;
    run t kind
  end

let coarsest effort kind (g : Graph.t) =
  let back = Graph.backwards g in
  let elements = Ints.make g.size and place = Ints.make g.size in
  for s = 0 to g.size - 1 do
    Ints.set elements s s;
    Ints.set place s s
  done;
  let one x =
    let b = Ints.buffer () in
    Ints.push b x;
    b
  in
  let t =
    {
      g;
      back;
      effort;
      block = Ints.make g.size;
      elements;
      place;
      begin_ = one 0;
      end_ = one g.size;
      dirty = one g.size;
      waiting = one 0;
      later = Ints.buffer ();
      signatures = Signatures.create ();
      signature = Ints.make g.size;
      closure = Closure.make effort g back;
      pending = Ints.buffer ();
    }
  in
  run t kind;
  { count = Ints.size t.begin_; block = t.block }
