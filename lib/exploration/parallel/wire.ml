open Scc_codec
open Scc_graph_search

module Make (E : Lts.Exchange) = struct
  type t = {
    context : E.context;
    labels : Dictionary.t;
    families : Dictionary.t array;
    family : int array;  (** of each slot *)
  }

  let make context =
    {
      context;
      labels = Dictionary.create ();
      families = Array.init (E.families context) (fun _ -> Dictionary.create ());
      family = Array.init (E.width context) (E.family context);
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

  let put_step w buffer (s : Lts.step) =
    put_label w buffer s.label;
    put_changes w buffer s.changes

  let read_step w source =
    let label = read_label w source in
    { Lts.label; changes = read_changes w source }
end
