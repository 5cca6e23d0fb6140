import vue from '@vitejs/plugin-vue';

const isCustomElement = (tag) => tag === 'cartoon-smoke';
export default { plugins: [vue({ template: { compilerOptions: { isCustomElement } } })] };
