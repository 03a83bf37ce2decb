open Scc_codec

type context = Network_lts.context

let width = Network_lts.width
let catalogue = Network_lts.catalogue
let codec = Network_lts.codec

(* The families are the kinds of slots. *)
let families _ = 4

let family c slot : int =
  match Catalogue.slot (catalogue c) slot with Process -> 0 | Step -> 1 | Time -> 2 | Mark -> 3

let bytes = Texts.bytes
let reading = Texts.reading

let component c ~family number =
  let catalogue = catalogue c in
  bytes (fun b ->
      match family with
      | 0 when number = Catalogue.nobody -> ()
      | 0 -> State_codec.put_process (codec c) b (Catalogue.body catalogue number).process
      | 1 -> State_codec.put_step b (Catalogue.step_of_number catalogue number)
      | 2 -> Packed.put_rational b (Catalogue.rational catalogue number)
      | _ -> Packed.put_list b Packed.put_nat (Network_lts.events_of_mark c number))

let of_component c ~family text =
  let catalogue = catalogue c in
  match family with
  | 0 when String.equal text "" -> Catalogue.nobody
  | 0 -> Catalogue.process catalogue (reading text (State_codec.process (codec c)))
  | 1 -> Catalogue.step_number catalogue (reading text State_codec.step)
  | 2 -> Catalogue.rational_number catalogue (reading text Packed.rational)
  | _ -> Network_lts.mark_of c (reading text (fun s -> Packed.list s Packed.nat))

let name c label = Texts.label (codec c) (Catalogue.any_label (catalogue c) label)

let of_name c text =
  let catalogue = catalogue c in
  match Texts.of_label (codec c) text with
  | One label -> Catalogue.label catalogue label
  | Tied (label, chance) -> Catalogue.tied catalogue label chance
  | Joint joint -> Catalogue.joint catalogue joint
