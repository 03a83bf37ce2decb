open Bigarray
open Answers

(* What a process finds of states that another one numbers. *)
module Make (L : Lts.S) = struct
  include Explored_graph.Make (L)

  let put (words : words) at word =
    if at >= Array1.dim words then raise Too_long;
    Array1.unsafe_set words at word

  (* As {!Explore} does it itself, by what is known of the target now. A state has its number before anything is
     noted of it: then the process that has given it looks at the edge. *)
  let[@inline] is_plain g s i label target =
    let own = Shared_states.noted s i and there = Shared_states.noted s target in
    (not (Shared_states.is_nothing there))
    && Shared_states.arrival_of there = Shared_states.arrival_of own
    &&
    let depth = Shared_states.depth_of own + transitions_of g label and known = Shared_states.depth_of there in
    known = depth || (known < depth && takes_time g label)

  (* A brief list leaves out edges of labels that are known, if they change nothing. *)
  let put_known g s ~brief words at i label target =
    let plain = is_plain g s i label target in
    if plain && brief && Shared_states.knows_label s label then at
    else begin
      put words at ((label lsl label_shift) lor (if plain then is_dull else 0) lor target);
      at + 1
    end

  (* Several states lead to a new one before it has a number. Where one of them that has its turn before leads to
     it as soon and by as few transitions, and this process has told its edge, a further edge changes nothing. *)
  let put_new g s ~dull ~brief words at i tuple ({ label; changes } : Lts.step) key =
    let way = if takes_time g label then 1 + label else -transitions_of g label in
    if brief && Shared_states.has_told s key ~from:i ~way && Shared_states.knows_label s label then at
    else begin
      let known = Shared_states.flags s key in
      let flags =
        if known >= 0 then known
        else begin
          let entered = if L.has_entered g.context changes then has_entered else 0 in
          if dull (Tuples.apply changes tuple) then entered lor is_dull else entered
        end
      in
      put words at ((label lsl label_shift) lor flags lor is_new);
      put words (at + 1) key;
      Shared_states.tell s key flags ~from:i ~way ~told:brief;
      at + 2
    end

  let prepare_steps g steps =
    let rec prepare prepared = function
      | [] -> prepared
      | { Lts.changes = [||]; _ } :: rest -> prepare prepared rest
      | (step : Lts.step) :: rest ->
        Tuples.prepare g.tuples ~near:g.near ~lasting:(not (takes_time g step.label)) step.changes prepared;
        prepare (prepared + 1) rest
    in
    Tuples.begin_round g.tuples ~near:g.near (List.length steps);
    Tuples.fetch g.tuples (prepare 0 steps)

  (* The first place after them; their heading is put before them. *)
  let put_steps g s ~dull ~brief words first i tuple steps =
    prepare_steps g steps;
    let rec each k at listed flags = function
      | [] ->
        put words first ((listed lsl flag_bits) lor flags);
        at
      | (step : Lts.step) :: rest ->
        if step.label >= most_label then raise Too_long;
        let flags = if Shared_states.knows_label s step.label then flags else flags land lnot labels_known in
        let flags = if takes_time g step.label then flags else flags land lnot all_timed in
        let is_here = Array.length step.changes = 0 in
        let known = if is_here then i else Tuples.prepared g.tuples k in
        let beyond =
          if known >= 0 then put_known g s ~brief words at i step.label known
          else put_new g s ~dull ~brief words at i tuple step (Tuples.prepared_key g.tuples k)
        in
        each (if is_here then k else k + 1) beyond (if beyond > at then listed + 1 else listed) flags rest
    in
    each 0 (first + 1) 0 (labels_known lor all_timed) steps

  (* The first place after the answer. Edges that change nothing may be left out where nobody asks for all, now
     or later. *)
  let put_answer g ~all_edges ~dull words at i =
    let s = match g.shared with Some s -> s | None -> Scc_base.Bug.fail __POS__ "a graph that is not shared" in
    Tuples.load g.tuples g.near i;
    let tuple = Tuples.slots g.near in
    let in_turn = match g.order with By_steps -> true | By_time -> false in
    let put_list ~brief at steps = put_steps g s ~dull ~brief words at i tuple steps in
    let lists some all =
      put words (at + 1) (Shared_states.version s);
      put words (at + 2) 0;
      let first = at + first_list in
      match some with
      | Some steps ->
        put words at 2;
        put_list ~brief:false (put_list ~brief:false first steps) all
      | None ->
        put words at 1;
        let brief = in_turn && (not all_edges) && not (Shared_states.may_turn s) in
        let beyond = put_list ~brief first all in
        if brief then put words (at + 2) (List.length all - count (word words first));
        beyond
    in
    let look () =
      put words at 0;
      at + 1
    in
    match (L.reduced g.context tuple, L.successors g.context tuple) with
    | _, (Error _ | Ok []) -> look ()
    | some, Ok all -> ( match lists some all with beyond -> beyond | exception Too_long -> look ())

  (** {2 Sharing} *)

  (* From now on processes that are forked see the states. *)
  let share g =
    match (Shared_states.create (), Common.create ~first:(L.numbers_so_far g.context)) with
    | Some s, Some common when Tuples.share g.tuples && L.share g.context common ->
      for i = 0 to size g - 1 do
        Shared_states.put s i ~depth:(depth g i) ~arrival:(Distances.arrival_number g.distances i)
      done;
      if may_turn g then Shared_states.note_turn s;
      g.shared <- Some s;
      Some common
    | _ -> None

  let unshare g =
    Tuples.unshare g.tuples;
    g.shared <- None

  let shared_bytes g =
    match g.shared with None -> 0 | Some s -> Tuples.bytes g.tuples + Shared_states.bytes s ~states:(size g)

  let refresh g common =
    Tuples.refresh g.tuples;
    Common.refresh common

  let is_room_wanted g common = Tuples.is_room_wanted g.tuples || Common.is_room_wanted common

  let make_room g common =
    if Tuples.is_room_wanted g.tuples then Tuples.make_room g.tuples;
    if Common.is_room_wanted common then Common.make_room common

  let go_on_apart g common ~full =
    Tuples.go_on_apart g.tuples ~full;
    Common.go_on_apart common ~full

  let set_full g common full =
    Tuples.set_full g.tuples full;
    Common.set_full common full
end
