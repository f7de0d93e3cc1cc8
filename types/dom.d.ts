/** What `el` and its kin take: attributes by name, listeners with the element that they stand on. */

type Listeners = {
  [K in keyof GlobalEventHandlersEventMap as `on${K}`]?:
    | ((event: GlobalEventHandlersEventMap[K] & { readonly target: any; readonly currentTarget: any }) => unknown)
    | null
    | false;
};

export type Properties = Listeners & { [name: string]: unknown };

export type Child = Node | string | number | null | undefined | false | Child[];
