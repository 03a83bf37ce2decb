open Scc_codec
open Scc_graph_search

module Make (E : Lts.Exchange) = struct
  type t = {
    context : E.context;
    labels : Dictionary.t;
    families : Dictionary.t array;
    family : int array;  (** of each slot *)
    mutable last : int array;  (** the tuple before *)
    steps : Lts.step array;  (** that came up lately, by {!place} *)
  }

  let no_step = { Lts.label = -1; changes = [||] }
  let places = 1 lsl 12

  let make context =
    {
      context;
      labels = Dictionary.create ();
      families = Array.init (E.families context) (fun _ -> Dictionary.create ());
      family = Array.init (E.width context) (E.family context);
      last = Array.make (E.width context) (-1);
      steps = Array.make places no_step;
    }

  let knows_label w = Dictionary.knows w.labels
  let put_label w buffer label = Dictionary.put w.labels buffer ~bytes:(E.name w.context) label
  let read_label w source = Dictionary.read w.labels source ~number:(E.of_name w.context)

  let put_number w buffer slot number =
    let family = w.family.(slot) in
    Dictionary.put w.families.(family) buffer ~bytes:(E.component w.context ~family) number

  let read_number w source slot =
    let family = w.family.(slot) in
    Dictionary.read w.families.(family) source ~number:(E.of_component w.context ~family)

  let slot w source = Packed.below (Array.length w.family) ~what:"the slot" source

  let put_changes w buffer changes =
    let count = Array.length changes / 2 in
    Packed.put_nat buffer count;
    for i = 0 to count - 1 do
      Packed.put_nat buffer changes.(2 * i);
      put_number w buffer changes.(2 * i) changes.((2 * i) + 1)
    done

  let read_changes w source =
    let count = Packed.below (Array.length w.family + 1) ~what:"so many slots: the number" source in
    let changes = Array.make (2 * count) 0 in
    for i = 0 to count - 1 do
      let slot = slot w source in
      changes.(2 * i) <- slot;
      changes.((2 * i) + 1) <- read_number w source slot
    done;
    changes

  (** {2 Tuples}: what is different in each from the one before. *)

  let put_tuple w buffer tuple =
    put_changes w buffer (Tuples.difference w.last tuple);
    w.last <- tuple

  let read_tuple w source =
    w.last <- Tuples.apply (read_changes w source) w.last;
    w.last

  (** {2 Steps}

      Many states have the same ones: the place of one that came up lately is told, from {!first_place} on. Both
      sides keep the same ones in the same places. *)

  let long = 0
  let kept = 1
  let first_place = 2

  (* Of a step of few changes. *)
  let place (s : Lts.step) =
    let mix h x = (h lxor x) * 0x1E3779B97F4A7C15 in
    (Array.fold_left mix (mix 0 s.label) s.changes lsr 40) land (places - 1)

  let is_short (s : Lts.step) = Array.length s.changes <= 8

  let rec same_from i (a : int array) b = i = Array.length a || (a.(i) = b.(i) && same_from (i + 1) a b)

  let are_same (s : Lts.step) (t : Lts.step) =
    s.label = t.label
    && (s.changes == t.changes
        || (Array.length s.changes = Array.length t.changes && same_from 0 s.changes t.changes))

  let put_step w buffer (s : Lts.step) =
    put_label w buffer s.label;
    put_changes w buffer s.changes

  let read_step w source =
    let label = read_label w source in
    { Lts.label; changes = read_changes w source }

  let put_recent w buffer s =
    if not (is_short s) then begin
      Packed.put_nat buffer long;
      put_step w buffer s
    end
    else begin
      let k = place s in
      if are_same w.steps.(k) s then Packed.put_nat buffer (first_place + k)
      else begin
        w.steps.(k) <- s;
        Packed.put_nat buffer kept;
        Packed.put_nat buffer k;
        put_step w buffer s
      end
    end

  let read_recent w source =
    let told = Packed.below (first_place + places) ~what:"the place of a step" source in
    if told >= first_place then w.steps.(told - first_place)
    else if told = long then read_step w source
    else begin
      let k = Packed.below places ~what:"the place of a step" source in
      let s = read_step w source in
      w.steps.(k) <- s;
      s
    end
end
