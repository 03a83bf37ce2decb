open Scc_base
open Statuses

(* Grows a graph by what other processes have found of a state ({!Ahead}). The graph is the same as if this process
   had found it. *)
module Make (L : Lts.S) = struct
  include Growing.Make (L)

  let tuple_of_key g key =
    Tuples.load_key g.tuples g.reader key;
    Tuples.slots g.reader

  (* The number of the target of the step at this place; -1 of one that is new. *)
  let known_target g words at =
    let step = Ahead.word words at in
    if Ahead.has Ahead.is_new step then Tuples.find_key g.tuples (Ahead.word words (at + 1)) else Ahead.target step

  let rec exists words at count test =
    count > 0 && (test at || exists words (Ahead.after words at) (count - 1) test)

  let is_ahead_at g i words at =
    match known_target g words at with
    | -1 -> true
    | j -> j <> i && (match status g j with Queued -> true | Expanded | Unexpanded _ -> false)

  (* Where the list is that is taken, and whether others are put off; [None] where nothing has been told. *)
  let choose g s i { words; at } =
    let first = at + Ahead.first_list in
    let left_out = Ahead.left_out words at in
    match Ahead.word words at with
    | 0 -> None
    (* What has been left out may change something now. *)
    | 1 when left_out > 0 && Ahead.version words at <> Shared_states.version s -> None
    | 1 -> Some (first, false)
    | _ ->
      if exists words (first + 1) (Ahead.count (Ahead.word words first)) (is_ahead_at g i words) then Some (first, true)
      else Some (Ahead.second_list words at, false)

  (* Whether the targets that are new, of so many transitions, fit a number of them. *)
  let fits_linked g room words at count =
    count <= room
    ||
    let fresh = Hashtbl.create 16 in
    let note at =
      if known_target g words at < 0 then Hashtbl.replace fresh (Ahead.word words (at + 1)) ();
      false
    in
    ignore (exists words at count note);
    Hashtbl.length fresh <= room

  (* In the order of the steps; those are left of which the visitor is to be told, the last first. *)
  let rec connect_all (g : t) limits i tuple words at n count untold =
    if n = count then untold
    else begin
      let step = Ahead.word words at in
      let label = Ahead.label step in
      Array.unsafe_set g.labels n label;
      if not (Ahead.has Ahead.is_new step) then begin
        Array.unsafe_set g.targets n (Ahead.target step);
        connect_all g limits i tuple words (at + 1) (n + 1) count untold
      end
      else begin
        let key = Ahead.word words (at + 1) and known = size g in
        let id = Tuples.intern_key g.tuples key in
        Array.unsafe_set g.targets n id;
        let untold =
          if id < known then untold
          else begin
            if not (Ahead.has Ahead.has_entered step) then
              L.entered g.context (Tuples.difference (Later.force tuple) (tuple_of_key g key));
            add g limits id (after g i label) (fun () -> tuple_of_key g key);
            if Ahead.has Ahead.is_dull step then untold else (id, key) :: untold
          end
        in
        connect_all g limits i tuple words (at + 2) (n + 1) count untold
      end
    end

  (* The places of several new targets in memory are fetched at the same time. *)
  let fetch g { words; at } =
    let rec touch at count found =
      if count = 0 then found
      else begin
        let is_new = Ahead.has Ahead.is_new (Ahead.word words at) in
        let found = if is_new then found lxor Tuples.touch_key g.tuples (Ahead.word words (at + 1)) else found in
        touch (if is_new then at + 2 else at + 1) (count - 1) found
      end
    in
    let first = at + Ahead.first_list in
    if Ahead.word words at = 1 then ignore (Sys.opaque_identity (touch (first + 1) (Ahead.count (Ahead.word words first)) 0))

  let introduce_all g around visitor = function
    | [] -> ()
    | untold ->
      let show (id, key) = visitor.found g id (tuple_of_key g key) in
      Limits.within around (fun () -> List.iter show (List.rev untold))

  (* The first edge to each new state has made it what it is. *)
  let rec relax_linked g limits visitor i words at n count ~next ~version =
    if n < count then begin
      let step = Ahead.word words at and target = Array.unsafe_get g.targets n in
      let is_known = not (Ahead.has Ahead.is_new step) in
      let beyond = if is_known then at + 1 else at + 2 in
      if target = next then relax_linked g limits visitor i words beyond (n + 1) count ~next:(next + 1) ~version
      else begin
        if not (is_known && version && Ahead.has Ahead.is_dull step) then
          ignore (relax_unless_plain g limits visitor i (Ahead.label step) target);
        relax_linked g limits visitor i words beyond (n + 1) count ~next ~version
      end
    end

  (* The same, where what matters is told. *)
  let relax_and_tell g limits visitor i tuple words at count ~next ~version told =
    let rec each at n next arrows =
      if n = count then List.rev arrows
      else begin
        let step = Ahead.word words at and target = Array.unsafe_get g.targets n in
        let label = Ahead.label step in
        let is_known = not (Ahead.has Ahead.is_new step) in
        let beyond = if is_known then at + 1 else at + 2 in
        if target = next then begin
          let changes = Tuples.difference (Later.force tuple) (tuple_of_key g (Ahead.word words (at + 1))) in
          each beyond (n + 1) (next + 1) (New { label; changes } :: arrows)
        end
        else begin
          let matters =
            (not (is_known && version && Ahead.has Ahead.is_dull step))
            && relax_unless_plain g limits visitor i label target
          in
          each beyond (n + 1) next (if matters || told.asks label then Known { label; target } :: arrows else arrows)
        end
      end
    in
    each at 0 next []

  (* Labels are known to this process once a state has been expanded that has them. *)
  let note_labels g s words at count =
    let note at =
      let label = Ahead.label (Ahead.word words at) in
      if not (Shared_states.knows_label s label) then begin
        ignore (L.duration g.context label);
        Shared_states.note_label s label
      end;
      false
    in
    ignore (exists words at count note)

  (* Expands a state by what was found of it; or says what ends the exploration. *)
  let grow_linked (g : t) (limits : Limits.t) around visitor expanded i s { words; at } (list, reduced) =
    let heading = Ahead.word words list and first_step = list + 1 in
    let count = Ahead.count heading in
    match limits.states with
    | Some n when not (fits_linked g (n - size g) words first_step count) -> Some States
    | Some _ | None ->
      mark g i Expanded;
      if reduced then Statuses.note_reduced g.statuses i;
      let first = size g in
      make_room_for_targets g count;
      if not (Ahead.has Ahead.labels_known heading) then note_labels g s words first_step count;
      let tuple = Later.make (fun () -> tuple g i) in
      let untold = connect_all g limits i tuple words first_step 0 count [] in
      let left_out = Ahead.left_out words at in
      g.transitions <- g.transitions + count + left_out;
      let labels () = Array.sub g.labels 0 count and targets () = Array.sub g.targets 0 count in
      Option.iter (fun store -> Edge_store.set store i ~labels:(labels ()) ~targets:(targets ())) g.edges;
      introduce_all g around visitor untold;
      let version = Ahead.version words at = Shared_states.version s in
      let told = expanded () in
      let arrows =
        match told with
        | Some told -> relax_and_tell g limits visitor i tuple words first_step count ~next:first ~version told
        | None ->
          relax_linked g limits visitor i words first_step 0 count ~next:first ~version;
          []
      in
      if (not reduced) && Ahead.has Ahead.all_timed heading then Statuses.note_timed g.statuses i
      else if left_out = 0 then remember_at_once g i count;
      let edges () = Array.map2 (fun label target -> { label; target }) (labels ()) (targets ()) in
      Option.iter
        (fun opened -> Limits.within around (fun () -> opened g i (Later.force tuple) (edges ())))
        visitor.opened;
      Option.iter (fun t -> t.tell i { arrows; count = count + left_out; reduced }) told;
      None
end
